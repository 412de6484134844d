#include "base/rounded.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "base/constants.hpp"

namespace vcrit {

namespace {

/// d.ddd times a power of ten, without zeros at the end.
struct DecimalNumber {
  std::string digits;  ///< of 0 a single one
  int exponent = 0;
};

/// Those of the shortest text that reads back to the same double, or zeros more.
int shortest_digits(double value) {
  const std::string text = fmt::format("{}", value);
  const auto end =
      text.begin() + static_cast<std::ptrdiff_t>(std::min(text.find('e'), text.size()));
  const auto first = std::find_if(text.begin(), end, [](char c) { return c >= '1' && c <= '9'; });
  const auto digits = end - first - std::count(first, end, '.');
  return std::clamp(static_cast<int>(digits), 1, all_digits);
}

/// Of a finite value, without its sign. The prefix moves the point of this text, so that it takes
/// no digit.
DecimalNumber decimal_number(double value, int digits) {
  value = std::abs(value);
  if (digits >= all_digits) digits = shortest_digits(value);
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  DecimalNumber number;
  std::copy_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(e),
               std::back_inserter(number.digits), [](char c) { return c != '.'; });
  while (number.digits.size() > 1 && number.digits.back() == '0') number.digits.pop_back();
  number.exponent = std::stoi(text.substr(e + 1));
  return number;
}

/// 10^power of the SI unit, by its name.
struct ChosenUnit {
  int power = 0;
  std::string name;
};

std::string prefixed(int power, std::string_view unit) {
  constexpr std::array prefixes{"p", "n", "µ", "m", "", "k", "M", "G"};
  return prefixes[static_cast<std::size_t>(power / 3 + 4)] + std::string(unit);
}

/// For numbers of 10^exponent. People write 0.1 µm rather than 100 nm, N/µm rather than MN/m, and
/// no kilometre, kilosecond, megagram, millihertz or mN/m.
ChosenUnit chosen_unit(int exponent, std::string_view unit) {
  if (unit.empty() || unit == "1") return {0, ""};
  if (unit == "rad/s" || unit == "rad") return {0, std::string(unit)};
  const int thousands = 3 * static_cast<int>(std::floor(exponent / 3.0));
  const bool small_alone = unit == "m" || unit == "m/s" || unit == "s" || unit == "kg";
  const bool large_alone = unit == "Hz" || unit == "N/m";
  int power = std::clamp(thousands, large_alone ? 0 : -12, small_alone ? 0 : 9);
  if (unit == "m" && exponent == -7) power = -6;
  if (unit == "kg") return {power, power == 0 ? "kg" : prefixed(power + 3, "g")};
  if (unit == "N/m" && power >= 6) return {power, prefixed(power - 6, "N/µm")};
  return {power, prefixed(power, unit)};
}

/// The point of 10^exponent behind its first digit, at its place; empty where zeros would be many.
std::string plain(const DecimalNumber& number, int exponent) {
  constexpr int most_zeros = 4, most_places = 9;
  if (exponent < -most_zeros || exponent > most_places) return {};
  std::string text = number.digits;
  if (exponent < 0) return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + text;
  const auto before = static_cast<std::size_t>(exponent) + 1;
  if (text.size() <= before) return text + std::string(before - text.size(), '0');
  return text.insert(before, ".");
}

std::string with_power(const DecimalNumber& number) {
  std::string text = number.digits;
  if (text.size() > 1) text.insert(1, ".");
  return text + " × " + power_of_ten(number.exponent);
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

/// The nearest of four digits, or its neighbour on the side of `towards` (1: above, -1: below).
std::string rounded_towards(int towards, double value, std::string_view unit) {
  if (!std::isfinite(value) || value == 0) return rounded(value, unit);
  const double step = std::pow(10.0, decimal_number(value, all_digits).exponent + 1 - few_digits);
  if (!(step > 0)) return rounded(value, unit);
  // 0.5 µm may be 499.99999999999994 nm.
  constexpr double rounding = 1e-12;
  const double steps = value / step, little = rounding * std::abs(steps);
  return rounded((towards > 0 ? std::ceil(steps - little) : std::floor(steps + little)) * step,
                 unit);
}

}  // namespace

std::string rounded(double value, std::string_view unit, int digits) {
  if (std::isnan(value)) return "not a number";
  const std::string sign = value < 0 ? "-" : "";
  if (std::isinf(value)) return sign + "∞";
  const ChosenUnit si = {0, chosen_unit(0, unit).name};
  if (value == 0) return with_unit("0", si.name);
  const DecimalNumber number = decimal_number(value, digits);
  const ChosenUnit chosen = chosen_unit(number.exponent, unit);
  const std::string text = plain(number, number.exponent - chosen.power);
  return sign +
         (text.empty() ? with_unit(with_power(number), si.name) : with_unit(text, chosen.name));
}

std::string rounded(double value, Dimension dimension, int digits) {
  return rounded(value, si_unit(dimension), digits);
}

std::string rounded_frequency(double omega, int digits) {
  return rounded(omega / two_pi, "Hz", digits);
}

std::string rounded_down(double value, std::string_view unit) {
  return rounded_towards(-1, value, unit);
}

std::string rounded_up(double value, std::string_view unit) {
  return rounded_towards(1, value, unit);
}

std::pair<std::string, std::string> rounded_apart(double a, double b, std::string_view unit) {
  for (int digits = few_digits;; ++digits) {
    std::pair both(rounded(a, unit, digits), rounded(b, unit, digits));
    if (both.first != both.second || a == b || digits == all_digits) return both;
  }
}

std::string whole_percent(double share) {
  // A share that is a whole per cent but for rounding is that.
  const double value = 100 * share * (1 + 1e-12);
  if (value >= 1) return fmt::format("{:.0f} %", std::floor(value));
  if (!(value > 0)) return "0 %";
  const int places = static_cast<int>(std::ceil(-std::log10(value)));
  const double unit = std::pow(10.0, places);
  return fmt::format("{:.{}f} %", std::floor(value * unit) / unit, places);
}

std::string power_of_ten(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  for (const char digit : std::to_string(exponent))
    text += digit == '-' ? "⁻" : digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

UnitScale scale_for(double largest, std::string_view unit) {
  const bool known = std::isfinite(largest) && largest != 0;
  const ChosenUnit chosen =
      chosen_unit(known ? decimal_number(largest, all_digits).exponent : 0, unit);
  return {std::pow(10.0, -chosen.power), chosen.name};
}

}  // namespace vcrit
