#include "figures/axis_scale.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rounded.hpp"

namespace vcrit::validation::figures {

namespace {

/// 1, 2 or 5 times a power of ten, the one nearest to `size` by ratio.
double round_step(double size) {
  const double power = std::pow(10.0, std::floor(std::log10(size))), rest = size / power;
  return power * (rest < std::sqrt(2.0)    ? 1
                  : rest < std::sqrt(10.0) ? 2
                  : rest < std::sqrt(50.0) ? 5
                                           : 10);
}

/// Of `step`, so that the sum of many steps ends on the last tick.
constexpr double almost = 1e-9;

std::vector<Tick> linear_ticks(double low, double high, int count) {
  const double step = round_step((high - low) / count);
  std::vector<Tick> ticks;  // 0.0 makes 0 of -0
  for (double n = std::ceil(low / step - almost) + 0.0; n <= high / step + almost; ++n)
    ticks.push_back({n * step, fmt::format("{:.6g}", n * step)});
  return ticks;
}

std::string power_words(int exponent) {
  return std::abs(exponent) <= 3 ? fmt::format("{:g}", std::pow(10.0, exponent))
                                 : power_of_ten(exponent);
}

/// Each power of ten, or each second, third, ... of many; ends are logarithms.
std::vector<Tick> logarithmic_ticks(double low, double high, int count) {
  const int first = static_cast<int>(std::ceil(low - almost)),
            last = static_cast<int>(std::floor(high + almost));
  if (last - first < 1) {
    std::vector<Tick> ticks = linear_ticks(std::pow(10.0, low), std::pow(10.0, high), count);
    std::erase_if(ticks, [](const Tick& tick) { return tick.at <= 0; });
    return ticks;
  }
  const int stride = std::max(1, (last - first + count) / count);
  std::vector<Tick> ticks;
  for (int n = first; n <= last; ++n)
    ticks.push_back({std::pow(10.0, n), (n - first) % stride == 0 ? power_words(n) : ""});
  return ticks;
}

/// On the scale of the axis.
double measured(double value, bool logarithmic) {
  if (!std::isfinite(value) || (logarithmic && value <= 0))
    return std::numeric_limits<double>::quiet_NaN();
  return logarithmic ? std::log10(value) : value;
}

/// Around a single value, as a part of it: labels have six digits.
constexpr double least_room = 1e-3;

/// Rounded outward to whole powers of ten, or whole steps; some range around a single value.
std::pair<double, double> extent(const std::vector<double>& shown, bool logarithmic, int count) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : shown) {
    const double place = measured(value, logarithmic);
    if (std::isnan(place)) continue;
    low = std::min(low, place);
    high = std::max(high, place);
  }
  if (low > high) return {0, 1};
  // Values that no label tells apart would have no step between them, and steps without end.
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low <= 4 * almost * (logarithmic ? std::max(1.0, size) : size)) {
    const double room = std::max(1.0, least_room * size);
    low -= room;
    high += room;
  }
  const double step = logarithmic ? 1 : round_step((high - low) / count);
  return {std::floor(low / step + almost) * step, std::ceil(high / step - almost) * step};
}

}  // namespace

AxisScale::AxisScale(const FigureAxis& axis, const std::vector<double>& shown, int count)
    : logarithmic_(axis.logarithmic) {
  const auto [low, high] = axis.range ? std::pair{measured(axis.range->first, logarithmic_),
                                                  measured(axis.range->second, logarithmic_)}
                                      : extent(shown, logarithmic_, count);
  low_ = low;
  high_ = high;
  for (const auto& [at, words] : axis.ticks) ticks_.push_back({at, words});
  if (ticks_.empty())
    ticks_ = logarithmic_ ? logarithmic_ticks(low, high, count) : linear_ticks(low, high, count);
}

double AxisScale::place(double value) const {
  return (measured(value, logarithmic_) - low_) / (high_ - low_);
}

}  // namespace vcrit::validation::figures
