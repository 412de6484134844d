#include "accuracy/data.hpp"

#include <algorithm>
#include <cmath>

namespace vcrit::validation::accuracy {

void Histogram::add(double error) {
  if (!std::isfinite(error)) {
    ++not_finite;
    return;
  }
  std::size_t i = 0;
  while (i + 1 < size && error > upper(i)) ++i;
  ++counts[i];
}

double Histogram::upper(std::size_t i) {
  return i == 0 ? 0 : i + 1 == size ? HUGE_VAL : std::ldexp(1, static_cast<int>(i) - 1);
}

}  // namespace vcrit::validation::accuracy
