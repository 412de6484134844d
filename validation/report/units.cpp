#include "report/units.hpp"

#include <fmt/core.h>

#include <cmath>

namespace vcrit::validation::report {

std::string quantity(double value, const std::string& unit, int digits) {
  return rounded(value, unit, digits);
}

std::string magnitude(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return "∞";
  const std::string text = fmt::format("{:.1e}", value);
  const auto e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{} × {}", text.substr(0, e), power_of_ten(exponent));
}

}  // namespace vcrit::validation::report
