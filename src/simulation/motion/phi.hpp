// phi_0(z) = e^z, phi_k(z) = (phi_{k-1}(z) - 1/(k-1)!)/z: the k-fold integral of e^{s t} from 0 is
// t^k phi_k(s t), with no cancellation at slow rates and none to special-case at s = 0.
#pragma once

#include <array>
#include <cmath>

#include "simulation/motion/pair_number.hpp"

namespace vcrit::simulation {

namespace detail {

constexpr std::array<double, 4> inverse_factorial{1, 1, 0.5, 1.0 / 6};

constexpr double power(double t, int k) { return k == 0 ? 1 : t * power(t, k - 1); }

// The series for |z| < 1: what is left out is below |z|^terms/terms!, 2e-16 at most.
template <class Number>
Number phi_series(int k, Number one, Number z, double size) {
  const int terms = size < 0.5 ? 13 : 18;
  Number sum = one * inverse_factorial[static_cast<std::size_t>(k)], term = sum;
  for (int n = 1; n < terms; ++n) {
    term = term * z * (1.0 / (n + k));
    sum = sum + term;
  }
  return sum;
}

}  // namespace detail

/// Any real x; k = 0..3.
inline double phi(int k, double x) {
  if (k == 0) return std::exp(x);
  if (std::abs(x) < 1)
    return k == 1 && x != 0 ? std::expm1(x) / x : detail::phi_series(k, 1.0, x, std::abs(x));
  double value = std::expm1(x) / x;
  for (int j = 2; j <= k; ++j)
    value = (value - detail::inverse_factorial[static_cast<std::size_t>(j - 1)]) / x;
  return value;
}

inline PairNumber phi(int k, PairNumber z) {
  if (k == 0) return exp(z);
  const double modulus = size(z);
  if (modulus < 1) return detail::phi_series(k, PairNumber{1, 0, z.q}, z, modulus);
  PairNumber value = exp(z);
  for (int j = 1; j <= k; ++j)
    value = (value - detail::inverse_factorial[static_cast<std::size_t>(j - 1)]) / z;
  return value;
}

/// (e^{r t} - e^{s t})/(r - s), the integral of e^{r x} e^{s (t - x)} over x from 0 to t.
inline double convolution(double r, double s, double t) {
  const double x = (r - s) * t;
  if (std::abs(x) < 1) return t * std::exp(s * t) * phi(1, x);
  return (std::exp(r * t) - std::exp(s * t)) / (r - s);
}
inline PairNumber convolution(PairNumber r, double s, double t) {
  const PairNumber x = (r - s) * t;
  if (size(x) < 1) return phi(1, x) * (t * std::exp(s * t));
  return (exp(r * t) - std::exp(s * t)) / (r - s);
}

/// The k-fold integral of e^{s t} from 0 to t.
inline double integral(int k, double s, double t) { return detail::power(t, k) * phi(k, s * t); }
inline PairNumber integral(int k, PairNumber s, double t) {
  return phi(k, s * t) * detail::power(t, k);
}

}  // namespace vcrit::simulation
