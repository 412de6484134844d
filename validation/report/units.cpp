#include "report/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "figures/axis_scale.hpp"

namespace vcrit::validation::report {

namespace {

constexpr std::array prefixes{"p", "n", "µ", "m", "", "k", "M", "G"};
constexpr int without_prefix = 4;  // the place of ""

}  // namespace

Scale scale_for(double largest, const std::string& unit) {
  largest = std::abs(largest);
  if (unit.empty() || unit == "rad/s" || largest == 0 || !std::isfinite(largest)) return {1, unit};
  const std::string base = unit == "kg" ? "g" : unit;
  const double in_base = unit == "kg" ? largest * 1000 : largest;
  const int thousands = static_cast<int>(std::floor(std::log10(in_base) / 3 + 1e-12));
  const int step = std::clamp(thousands, -without_prefix, 3);
  const double factor = std::pow(10.0, -3 * step) * (unit == "kg" ? 1000 : 1);
  const int prefix = step + without_prefix;
  return {factor, prefixes[static_cast<std::size_t>(prefix)] + base};
}

std::string quantity(double value, const std::string& unit, int digits) {
  if (!std::isfinite(value)) return value > 0 ? "∞" : "not a number";
  const Scale scale = scale_for(value, unit);
  const std::string number = fmt::format("{:.{}g}", value * scale.factor, digits);
  return scale.unit.empty() ? number : number + " " + scale.unit;
}

std::string magnitude(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return "∞";
  const std::string text = fmt::format("{:.1e}", value);
  const auto e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{} × {}", text.substr(0, e), figures::power_of_ten(exponent));
}

}  // namespace vcrit::validation::report
