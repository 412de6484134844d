// e^{s t}, its integrals from 0 and convolutions, for decays, pairs of modes and the oscillation,
// with no cancellation at slow rates and nothing to special-case at s = 0:
//   once = t + s twice,  twice = t^2 phi_2(s t),  phi_2(z) = (e^z - 1 - z)/z^2 = sum_n z^n/(n + 2)!
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "modes/pair_number.hpp"

namespace vcrit::simulation {

/// e^{s t}, its integral and its double integral from 0 to t.
template <class Number>
using Integrals = std::array<Number, 3>;

namespace detail {

inline constexpr std::array<double, 17> inverse_factorial = [] {
  std::array<double, 17> table{};
  double factorial = 1;
  for (std::size_t n = 0; n < table.size(); ++n)
    table[n] = 1 / (factorial *= static_cast<double>(n + 2));
  return table;
}();

}  // namespace detail

inline double magnitude(double x) { return std::abs(x); }

/// phi_2(z) for a modulus |z| < 1: the terms left out are below 2e-16 of it.
template <class Number>
Number phi_2(Number z, double modulus) {
  std::size_t n = modulus < 0.05 ? 8 : (modulus < 0.5 ? 13 : 17);
  Number sum = z * 0.0 + detail::inverse_factorial[--n];
  while (n > 0) sum = sum * z + detail::inverse_factorial[--n];
  return sum;
}

/// Of a decay, s = -rate.
inline Integrals<double> integrals(double rate, double t) {
  const double x = rate * t;
  if (x < 1) {
    const double twice = t * t * phi_2(-x, x), once = t - rate * twice;
    return {1 - rate * once, once, twice};
  }
  const double none = std::exp(-x), once = (1 - none) / rate;
  return {none, once, (t - once) / rate};
}

/// Of a pair of modes, with 1/s and the size of s at hand.
inline Integrals<PairNumber> integrals(PairNumber s, PairNumber inverse, double size, double t) {
  if (size * t < 1) {
    const PairNumber twice = phi_2(s * t, size * t) * (t * t), once = s * twice + t;
    return {s * once + 1, once, twice};
  }
  const PairNumber none = exp(s * t), once = (none - 1) * inverse;
  return {none, once, (once - t) * inverse};
}

/// Of the oscillation, s = sigma = i: (e^{it} - 1)/i = sin t + i (1 - cos t), and once more.
inline Integrals<PairNumber> turn_integrals(double t) {
  const double sine = std::sin(0.5 * t), cosine = std::cos(0.5 * t);
  const double whole = 2 * sine * cosine, fall = 2 * sine * sine;
  double lag = t - whole;
  if (t < 1) {
    const double x = t * t;
    lag = 1;
    for (int n = 14; n > 2; n -= 2) lag = 1 - lag * x * (1.0 / (n * (n + 1)));
    lag *= t * x / 6;
  }
  return {PairNumber{1 - fall, whole, -1}, {whole, fall, -1}, {fall, lag, -1}};
}

/// What a convolution takes with its integral, in units of effort.
inline constexpr std::size_t convolution_work = 2;

/// Integral of e^{r x} e^{s (t - x)} over x from 0 to t, (e^{r t} - e^{s t})/(r - s), from its two
/// exponentials.
template <class Number>
Number convolution(Number r, Number exp_r, double s, double exp_s, double t) {
  const Number x = (r - s) * t;
  const double modulus = magnitude(x);
  if (modulus < 1) return (x * phi_2(x, modulus) + 1) * (t * exp_s);
  return (exp_r - exp_s) / (r - s);
}

/// The integral of that convolution from 0 to t, (once_r - once_s)/(r - s), from the integrals of
/// its exponentials and itself.
template <class Number>
Number integrated_convolution(Number r, Number once_r, double s, double once_s, Number convolved,
                              double t) {
  const Number apart = r - s;
  const double modulus = std::max(magnitude(apart), magnitude(r)) * t;
  if (modulus >= 0.5)
    return magnitude(apart) >= magnitude(r) ? (once_r - once_s) / apart : (convolved - once_s) / r;
  // t^2 sum_n h_n/(n + 2)!, h_n the sum of all products of n factors r t and s t.
  Number h = r * 0.0 + 1, sum = h * detail::inverse_factorial[0];
  double power = 1;
  // Of those left out none is half a bit of the sum: |s t| is below 0.1, h_n below 2 |s t|^n.
  const std::size_t terms = modulus < 0.05 ? 11 : detail::inverse_factorial.size();
  for (std::size_t n = 1; n < terms; ++n) {
    power *= s * t;
    h = h * (r * t) + power;
    sum = sum + h * detail::inverse_factorial[n];
  }
  return sum * (t * t);
}

}  // namespace vcrit::simulation
