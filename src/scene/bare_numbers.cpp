#include "scene/bare_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/constants.hpp"
#include "base/numbers.hpp"

namespace vcrit {

namespace {

struct Usual {
  const char* key;
  double least, most;      // beyond these another unit is meant
  const char* unit;        // of a bare number
  const char* words;       // the same in words
  const char* other_unit;  // that is meant
};

// Ultrasonic vibration has micrometres: a millimetre at 20 kHz would be 1.6 million times gravity,
// and an indentation of a millimetre is thousands of such amplitudes. Vibration below 100 Hz is no
// sound that a transducer makes, but the number of some kilohertz is. Slower or larger machines
// exist: with its unit the number is not asked about.
constexpr double most_length = 1e-3, least_frequency = 100, most_radius = 1;
constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr std::array<Usual, 5> usual_numbers{
    {{"amplitude", 0, most_length, "m", "metres", "um"},
     {"indentation", 0, most_length, "m", "metres", "um"},
     {"radius", 0, most_radius, "m", "metres", "mm"},
     {"frequency", least_frequency, no_limit, "Hz", "hertz", "kHz"},
     {"angular_frequency", least_frequency* two_pi, no_limit, "rad/s", "radians a second",
      "krad/s"}}};

/// "N/um" of "8 N/um"; nothing of a bare number. The text is a quantity already.
std::string unit_of(const std::string& text) {
  const auto begin = text.find_first_of("0123456789");
  if (begin == text.npos) return {};
  const std::string number_and_unit = text.substr(begin);
  const auto end =
      std::min(number_and_unit.find_first_not_of("0123456789.+-eE"), number_and_unit.size());
  const std::size_t length =
      leading_number(std::string_view(number_and_unit).substr(0, end)).length;
  const auto unit = number_and_unit.find_first_not_of(" \t", length);
  return unit == number_and_unit.npos ? std::string() : number_and_unit.substr(unit);
}

}  // namespace

std::string nearer_unit(double set, const std::string& text, Dimension dimension) {
  const std::string unit = unit_of(text);
  if (unit.empty() || !(set > 0)) return {};
  const double own = parse_quantity(text, dimension, {});
  // May be infinite, which is far from all.
  const double meant = set * parse_quantity("1 " + unit, dimension, {});
  if (!(own > 0 && meant > 0)) return {};
  const bool nearer = std::abs(std::log(meant / own)) < std::abs(std::log(set / own));
  return nearer ? unit : std::string();
}

std::vector<Warning> suspicious_bare_numbers(const std::vector<BareNumber>& numbers) {
  std::vector<Warning> warnings;
  for (const BareNumber& it : numbers) {
    const std::string number = to_text(it.value);
    const auto* usual =
        std::find_if(usual_numbers.begin(), usual_numbers.end(), [&](const Usual& row) {
          return it.key == row.key && it.value != 0 &&
                 !(it.value >= row.least && it.value < row.most);
        });
    if (usual != usual_numbers.end())
      warnings.push_back(
          {it.place,
           fmt::format("{} {} {}: a bare number is in {}; if {} are meant, write \"{} {}\"", it.key,
                       number, usual->unit, usual->words, usual->other_unit, number,
                       usual->other_unit)});
    else if (!it.unit.empty())
      warnings.push_back(
          {it.place, fmt::format("{0} {1} {2}: a bare number is in {2}, and the scene gives {0} in "
                                 "{3}; if that is meant, write \"{1} {3}\"",
                                 it.key, number, si_unit(it.dimension), it.unit)});
  }
  return warnings;
}

}  // namespace vcrit
