// Sweeps by hand, with the coefficients reduced once a parameter set: numerators and denominators
// as polynomials in s, evaluated by their even and odd parts (even_and_odd); or the squares of
// their absolute values, multiplied out to one polynomial in w^2 over another (squares). Compiled
// at run time for VCRIT_SCENE.
#include <cmath>

#include "speed/peers/columns.hpp"
#include "speed/peers/networks.hpp"
#include "speed/peers/polynomials.hpp"

namespace by_hand {

namespace {

// |p(i w)|^2 at W = w^2.
inline One square_at(One, double) { return {}; }
inline double square_at(double a, double) { return a * a; }
inline double square_at(Detuning d, double W) { return (d.k - d.m * W) * (d.k - d.m * W); }
template <int n>
inline double square_at(const Polynomial<n>& p, double W) {
  const double even = horner<0, 2>(p, -W);
  if constexpr (n == 0) {
    return even * even;
  } else {
    const double odd = horner<1, 2>(p, -W);
    return even * even + W * (odd * odd);
  }
}

// |p(i w)|^2 as a polynomial in w^2.
inline One square_of(One) { return {}; }
inline double square_of(double a) { return a * a; }
inline One square_of(Detuning) { return {}; }
template <int n>
Polynomial<n> square_of(const Polynomial<n>& p) {
  Polynomial<n> square;
  for (std::size_t k = 0; k <= n; ++k)
    for (std::size_t i = 2 * k > n ? 2 * k - n : 0; i <= 2 * k && i <= n; ++i)
      square.a[k] += (k + i) % 2 == 0 ? p.a[i] * p.a[2 * k - i] : -(p.a[i] * p.a[2 * k - i]);
  return square;
}
inline double value_at(double a, double) { return a; }
template <int n>
inline double value_at(const Polynomial<n>& p, double W) {
  // Two chains of operations instead of one of twice the length.
  if constexpr (n < 4)
    return horner<0, 1>(p, W);
  else
    return horner<0, 2>(p, W * W) + W * horner<1, 2>(p, W * W);
}
template <class A>
inline One apart(const A&, double) {
  return {};
}
inline double apart(Detuning d, double W) { return square_at(d, W); }

// A power of two near omega: exact.
double unit_of(double omega) { return std::exp2(std::round(std::log2(omega))); }

}  // namespace

extern "C" [[gnu::flatten]] void even_and_odd(const double* const* x, std::size_t n,
                                              double* __restrict out, double*) {
  const auto values = first_values<Problem::columns>(x);
  const double* __restrict const omega = x[1];
  const double unit = unit_of(omega[0]), factor = values[0] * values[2], inverse = 1.0 / unit;
  const auto q = Problem::quotient(InPowersOfS{values.data(), unit});
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const double w = omega[i] * inverse, W = w * w;
    out[i] =
        factor * omega[i] *
        std::sqrt(square_at(q.over_a, W) * square_at(q.over_b, W) /
                  (square_at(q.under_a, W) * square_at(q.under_b, W) * square_at(q.under_c, W)));
  }
}

extern "C" [[gnu::flatten]] void squares(const double* const* x, std::size_t n,
                                         double* __restrict out, double*) {
  const auto values = first_values<Problem::columns>(x);
  const double* __restrict const omega = x[1];
  const double unit = unit_of(omega[0]), factor = values[0] * values[2], inverse = 1.0 / unit;
  const auto q = Problem::quotient(InPowersOfS{values.data(), unit});
  const auto over = square_of(q.over_a) * square_of(q.over_b);
  const auto under = square_of(q.under_a) * square_of(q.under_b) * square_of(q.under_c);
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const double w = omega[i] * inverse, W = w * w;
    out[i] = factor * omega[i] *
             std::sqrt(value_at(over, W) / (value_at(under, W) * apart(q.under_c, W)));
  }
}

}  // namespace by_hand
