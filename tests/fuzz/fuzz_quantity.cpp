// Numbers with units, in every dimension. What is accepted is finite, reads back from its own
// print, is as many times its unit as was typed, and belongs to one dimension only unless it is a
// plain number or an angle, which is one.
#include <array>
#include <cmath>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "fuzz.hpp"

using namespace vcrit;

namespace {

// A conversion rounds some times, and decimal numbers once. Above what loses digits to underflow.
constexpr double rounding = 1e-14, least = 1e-290;

/// Against "1 UNIT" and "0 UNIT", where these are the multiples that they look like.
void check_multiple(const std::string& text, const TypedNumber& typed, Dimension dimension) {
  const auto begin = std::min(text.find_first_not_of(" \t"), text.size());
  const LeadingNumber number = leading_number(std::string_view(text).substr(begin));
  const std::string unit = text.substr(begin + number.length);
  if (!number.value || parse_quantity("0 " + unit, dimension, {}) != 0) return;
  const double one = parse_quantity("1 " + unit, dimension, {}), product = *number.value * one;
  if (std::abs(*number.value) < least || std::abs(one) < least || std::abs(product) < least) return;
  fuzz::check(
      !std::isfinite(product) || std::abs(typed.value - product) <= rounding * std::abs(product),
      "a quantity is a number of its unit");
}

}  // namespace

void fuzz::read_quantity(const std::string& text) {
  constexpr std::array dimensions{
      Dimension::none,      Dimension::stiffness,        Dimension::damping,  Dimension::time,
      Dimension::mass,      Dimension::length,           Dimension::velocity, Dimension::force,
      Dimension::frequency, Dimension::angular_frequency};
  std::size_t accepted = 0;
  bool is_bare = false;
  for (const Dimension dimension : dimensions)
    fuzz::answered([&] {
      const TypedNumber typed = parse_typed(text, dimension, {"scene.toml", 1, 1});
      const double value = typed.value;
      ++accepted;
      is_bare = typed.is_bare;
      fuzz::check(typed.decimal.empty() || to_double(typed.decimal) == value,
                  "the decimal number is the value");
      check_multiple(text, typed, dimension);
      fuzz::check(std::isfinite(value), "a quantity is finite");
      fuzz::check(parse_quantity(to_text(value), dimension, {}) == value, "a number reads back");
    });
  fuzz::check(accepted <= 1 || is_bare, "a unit is one of one dimension");
}
