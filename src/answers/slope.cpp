#include "answers/slope.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit {

namespace {

// Differences of fourth order err by the fourth power of a step, 1e-12, and noise over a step.
constexpr double usual_step = 1e-3, widest_step = 0.05, narrowest_step = 1e-9, shrinking = 4;
constexpr double good_enough = 1e-7;

// f at -4 to 4 steps.
using Samples = std::array<double, 9>;

Slope slope_of(const Samples& f, double step, double noise) {
  const auto at = [&](int i) { return f[static_cast<std::size_t>(i + 4)]; };
  const auto central = [&](int i) {
    return (8 * (at(i) - at(-i)) - (at(2 * i) - at(-2 * i))) / (12 * i * step);
  };
  const auto to_side = [&](int i) {
    const double change =
        -25 * at(0) + 48 * at(i) - 36 * at(2 * i) + 16 * at(3 * i) - 3 * at(4 * i);
    return change / (12 * i * step);
  };
  Slope slope{central(1), 0, to_side(-1), to_side(1)};
  slope.error = std::max({std::abs(slope.above - slope.below), std::abs(slope.value - central(2)),
                          1.5 * noise / step});
  return slope;
}

std::optional<Samples> samples_of(const std::function<std::optional<double>(double)>& f,
                                  double step) {
  Samples values{};
  for (int i = -4; i <= 4; ++i) {
    const std::optional<double> value = f(i * step);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values[static_cast<std::size_t>(i + 4)] = *value;
  }
  return values;
}

}  // namespace

Slope slope_at_zero(const std::function<std::optional<double>(double)>& f, double noise) {
  Slope best{0, infinity, 0, 0};
  double step = std::clamp(std::pow(noise, 0.2), usual_step, widest_step);
  for (; step >= narrowest_step; step /= shrinking) {
    if (1.5 * noise / step >= best.error) break;  // no shorter step is better
    const auto values = samples_of(f, step);
    if (!values) continue;
    const Slope slope = slope_of(*values, step, noise);
    if (slope.error < best.error) best = slope;
    if (best.error <= good_enough * std::max(1.0, std::abs(best.value))) break;
  }
  return best;
}

}  // namespace vcrit
