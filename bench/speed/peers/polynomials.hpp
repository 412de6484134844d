// Polynomials of fixed degree, and the elements of a problem as such.
#pragma once

#include <array>
#include <cstddef>

#include "speed/peers/numbers.hpp"

namespace by_hand {

template <int n>
struct Polynomial {
  static constexpr int degree = n;
  std::array<double, n + 1> a{};
};

template <int n, int m>
auto operator+(const Polynomial<n>& p, const Polynomial<m>& q) {
  if constexpr (n < m) {
    return q + p;
  } else {
    Polynomial<n> sum = p;
    for (std::size_t i = 0; i <= m; ++i) sum.a[i] += q.a[i];
    return sum;
  }
}
template <int n, int m>
Polynomial<n + m> operator*(const Polynomial<n>& p, const Polynomial<m>& q) {
  Polynomial<n + m> product;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= m; ++j) product.a[i + j] += p.a[i] * q.a[j];
  return product;
}
template <int n>
Polynomial<n> operator+(Polynomial<n> p, double x) {
  p.a[0] += x;
  return p;
}
template <int n>
Polynomial<n> operator+(double x, const Polynomial<n>& p) {
  return p + x;
}
template <int n>
Polynomial<n> operator+(const Polynomial<n>& p, One) {
  return p + 1.0;
}
template <int n>
Polynomial<n> operator*(double x, Polynomial<n> p) {
  for (double& each : p.a) each *= x;
  return p;
}
template <int n>
Polynomial<n> operator*(const Polynomial<n>& p, double x) {
  return x * p;
}

// k + m s^2 of an elastic drive: squared when it has a value, so that nothing is lost near
// resonance.
struct Detuning {
  double k, m;
};
struct Inertia {
  double m;
};
inline Inertia operator*(Inertia inertia, One) { return inertia; }
inline Detuning operator+(double k, Inertia inertia) { return {k, inertia.m}; }
inline Polynomial<2> as_polynomial(Inertia inertia) { return {{0.0, 0.0, inertia.m}}; }
inline Polynomial<2> as_polynomial(Detuning d) { return {{d.k, 0.0, d.m}}; }
template <int n>
auto operator+(const Polynomial<n>& p, Inertia inertia) {
  return p + as_polynomial(inertia);
}
template <int n>
auto operator*(Inertia inertia, const Polynomial<n>& p) {
  return as_polynomial(inertia) * p;
}
template <int n>
auto operator*(Detuning d, const Polynomial<n>& p) {
  return as_polynomial(d) * p;
}
template <int n>
auto operator+(const Polynomial<n>& p, Detuning d) {
  return p + as_polynomial(d);
}

// Elements of one parameter set; s in units of `unit`.
struct InPowersOfS {
  const double* values;
  double unit;
  [[gnu::always_inline]] double operator[](int j) const { return values[j]; }
  [[gnu::always_inline]] InPowersOfS after(int j) const { return {values + j, unit}; }
  [[gnu::always_inline]] Polynomial<1> damper(int j) const { return {{0.0, values[j] * unit}}; }
  [[gnu::always_inline]] Inertia inertia(int j) const { return {values[j] * unit * unit}; }
};

// Horner's rule for every `step`-th coefficient from `first` on.
template <int first, int step, int n>
inline double horner(const Polynomial<n>& p, double x) {
  if constexpr (first + step > n)
    return p.a[first];
  else
    return p.a[first] + x * horner<first + step, step>(p, x);
}

}  // namespace by_hand
