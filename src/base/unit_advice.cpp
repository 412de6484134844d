#include "base/unit_advice.hpp"

#include <fmt/core.h>

#include <array>
#include <cctype>
#include <cstddef>
#include <span>
#include <utility>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "base/sort_stably.hpp"
#include "base/trimmed.hpp"

namespace vcrit {

namespace {

using Units = std::vector<std::string>;

// As scenes write them; more than these are read.
const Units& usual_units(Dimension dimension) {
  static const Units none{},
      stiffness{"N/um", "N/mm", "N/m", "kN/m", "kN/mm", "MN/m", "mN/um", "mN/m"},
      damping{"N.s/m", "N.s/mm", "N.s/um", "mN.s/m", "kN.s/m", "kg/s"},
      modulus{"MPa", "GPa", "kPa", "Pa", "N/mm^2"}, viscosity{"Pa.s", "mPa.s", "kPa.s", "MPa.s"},
      time{"s", "ms", "us", "ns", "min", "h"}, mass{"g", "kg", "mg"},
      length{"um", "nm", "mm", "cm", "m"}, angle{"deg", "rad", "mrad"},
      velocity{"mm/s", "um/s", "cm/s", "m/s", "km/h"}, force{"N", "mN", "kN", "uN"},
      compliance{"um/N", "mm/N", "nm/N", "m/N"}, frequency{"kHz", "Hz", "MHz", "mHz", "GHz"},
      angular{"rad/s", "krad/s", "rpm", "deg/s"};
  switch (dimension) {
    case Dimension::none:
      return none;
    case Dimension::stiffness:
      return stiffness;
    case Dimension::damping:
      return damping;
    case Dimension::modulus:
      return modulus;
    case Dimension::viscosity:
      return viscosity;
    case Dimension::time:
      return time;
    case Dimension::mass:
      return mass;
    case Dimension::length:
      return length;
    case Dimension::angle:
      return angle;
    case Dimension::velocity:
      return velocity;
    case Dimension::force:
      return force;
    case Dimension::frequency:
      return frequency;
    case Dimension::angular_frequency:
      return angular;
    case Dimension::compliance:
      return compliance;
  }
  return none;
}

// Without capitals, and without what stands between two units that are multiplied.
std::string folded(std::string_view unit) {
  std::string text;
  for (const char c : unit)
    if (c != '.' && c != '*' && c != ' ')
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// "u", as the usual units have it, for both micro signs.
std::string with_plain_micro(std::string unit) {
  for (const std::string_view micro : {"\u00b5", "\u03bc"})
    for (auto at = unit.find(micro); at != unit.npos; at = unit.find(micro))
      unit.replace(at, micro.size(), "u");
  return unit;
}

constexpr std::size_t most_units_offered = 2;

Units best(std::vector<std::pair<std::size_t, std::string>> found) {
  sort_stably(found, [](const auto& a, const auto& b) { return a.first < b.first; });
  Units units;
  for (const auto& [distance, unit] : found)
    if (units.size() < most_units_offered) units.push_back(unit);
  return units;
}

constexpr std::array<std::string_view, 8> peak_to_peak{
    "peak to peak", "peak-to-peak", "pk-pk", "p-p", "p/p", "ptp", "pkpk", "pp"};

constexpr std::array<std::string_view, 2> root_mean_square{"rms", "RMS"};

constexpr std::array<std::string_view, 8> peak{
    "zero to peak", "zero-to-peak", "0-to-peak", "0-peak", "0-pk", "0-p", "peak", "pk"};

std::string_view before_any(std::string_view unit, std::span<const std::string_view> ends) {
  if (unit.ends_with(')')) unit.remove_suffix(1);
  for (const std::string_view end : ends)
    if (unit.size() > end.size() && unit.ends_with(end))
      return trimmed(unit.substr(0, unit.size() - end.size()), " \t_,(");
  return {};
}

bool is_digit_at(std::string_view text, std::size_t i) {
  return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
}

}  // namespace

Units nearest_units(std::string_view unit, Dimension dimension) {
  if (is_mistaken_unit(unit) && dimension == Dimension::mass) return {"g"};
  std::vector<std::pair<std::size_t, std::string>> same, near;
  for (const std::string& each : usual_units(dimension)) {
    if (folded(each) == with_plain_micro(folded(unit)))
      same.emplace_back(edit_distance(each, unit), each);
    // Of one letter everything is one letter away.
    if (each.size() > 1 && unit.size() > 1 && edit_distance(folded(each), folded(unit)) == 1)
      near.emplace_back(edit_distance(each, unit), each);
  }
  return best(same.empty() ? near : same);
}

std::string advice_on_unknown_unit(std::string_view number, std::string_view unit,
                                   Dimension dimension) {
  Units whole;
  for (const std::string& each : nearest_units(unit, dimension))
    whole.push_back(fmt::format("\"{} {}\"", number, each));
  return whole.empty() ? "" : fmt::format("did you mean {}?", joined(whole, " or "));
}

std::string_view before_peak_to_peak(std::string_view unit) {
  return before_any(unit, peak_to_peak);
}

std::string_view before_root_mean_square(std::string_view unit) {
  return before_any(unit, root_mean_square);
}

std::string_view before_peak(std::string_view unit) { return before_any(unit, peak); }

bool is_mistaken_unit(std::string_view unit) { return unit == "gr"; }

std::string advice_on_comma(std::string_view number, std::string_view rest) {
  if (!rest.starts_with(',') || !is_digit_at(rest, 1)) return "";
  const std::string_view tail = rest.substr(1);
  if (number.find('.') != number.npos) {  // between thousands
    std::string whole(number);
    std::erase(whole, '.');
    return fmt::format("write a decimal point, and nothing between thousands: \"{}.{}\"", whole,
                       tail);
  }
  const std::string point = fmt::format("\"{}.{}\"", number, tail);
  const bool may_be_thousands =
      is_digit_at(tail, 1) && is_digit_at(tail, 2) && !is_digit_at(tail, 3);
  if (!may_be_thousands) return "write a decimal point: " + point;
  return fmt::format("write a decimal point, {}, and nothing between thousands, \"{}{}\"", point,
                     number, tail);
}

std::string advice_on_thousands(std::string_view number, std::string_view rest) {
  constexpr std::size_t group = 3;
  std::string whole(number);
  if (number.find_first_of(".eE") != number.npos) return "";
  for (;;) {
    const std::size_t begin = rest.starts_with('\'') ? 1 : 0;
    for (std::size_t i = 0; i < group; ++i)
      if (!is_digit_at(rest, begin + i)) return "";
    if (is_digit_at(rest, begin + group)) return "";
    whole += rest.substr(begin, group);
    rest = trimmed(rest.substr(begin + group), " \t");
    if (rest.starts_with('\'') || is_digit_at(rest, 0)) continue;
    const char* const space = rest.empty() || rest.starts_with('.') ? "" : " ";
    return fmt::format("write nothing between thousands: \"{}{}{}\"", whole, space, rest);
  }
}

bool has_typeset_minus(std::string_view text) {
  return text.find("\u2212") != text.npos || text.find("\u2013") != text.npos;
}

}  // namespace vcrit
