#include "report/units.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <string_view>

namespace vcrit::validation::report {

std::string quantity(double value, const std::string& unit, int digits) {
  return rounded(value, unit, digits);
}

// The next word after a number is its unit, or what is counted: it may as well stay.
std::string unbroken(const std::string& words) {
  std::string result;
  for (const char c : words) {
    const bool after_digit =
        !result.empty() && std::isdigit(static_cast<unsigned char>(result.back())) != 0;
    if (c == ' ' && (after_digit || result.ends_with("×")))
      result += "\u00a0";
    else
      result += c;
  }
  return result;
}

std::string motion_words(const std::string& regime) {
  constexpr std::string_view apart = "-apart";
  if (regime.ends_with(apart))
    return motion_words(regime.substr(0, regime.size() - apart.size())) + ", and the contact opens";
  if (regime == "sliding") return "continuous sliding";
  if (regime == "stick") return "sticking";
  if (regime == "stick-slip-backslip") return "stick-slip with reverse slip";
  return regime;
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
