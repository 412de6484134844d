// The parameters as the methods get them: columns of equal length, or (sweep) one value each and a
// column of omega.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "speed/peers/numbers.hpp"

namespace by_hand {

// Elements as numbers at one frequency.
template <class Access>
struct At {
  Access values;
  double omega;
  int first = 0;

  [[gnu::always_inline]] double operator[](int j) const { return values(first + j); }
  [[gnu::always_inline]] At after(int j) const { return {values, omega, first + j}; }
  [[gnu::always_inline]] Imaginary damper(int j) const { return {omega * (*this)[j]}; }
  // m s^2
  [[gnu::always_inline]] double inertia(int j) const { return -(((*this)[j] * omega) * omega); }
  // k + m s^2, rounded little more than once
  [[gnu::always_inline]] double less_inertia(double k, int j) const {
    const double m = (*this)[j], t = m * omega, rest = std::fma(m, omega, -t);
    return std::fma(-rest, omega, std::fma(-t, omega, k));
  }
};

struct Varying {
  const double* const* columns;
  std::size_t i;
  [[gnu::always_inline]] double operator()(int j) const { return columns[j][i]; }
};

struct Fixed {
  const double* values;
  [[gnu::always_inline]] double operator()(int j) const { return values[j]; }
};

// A copy that nothing can alias.
template <std::size_t columns>
std::array<double, columns> first_values(const double* const* x) {
  std::array<double, columns> values;
  for (std::size_t j = 0; j < columns; ++j) values[j] = x[j][0];
  return values;
}

}  // namespace by_hand
