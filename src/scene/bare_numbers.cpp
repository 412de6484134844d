#include "scene/bare_numbers.hpp"

#include <fmt/core.h>

#include <array>

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
constexpr double no_limit = 1e300;
constexpr std::array<Usual, 5> usual_numbers{
    {{"amplitude", 0, most_length, "m", "metres", "um"},
     {"indentation", 0, most_length, "m", "metres", "um"},
     {"radius", 0, most_radius, "m", "metres", "mm"},
     {"frequency", least_frequency, no_limit, "Hz", "hertz", "kHz"},
     {"angular_frequency", least_frequency* two_pi, no_limit, "rad/s", "radians a second",
      "krad/s"}}};

}  // namespace

std::vector<Warning> suspicious_bare_numbers(const std::vector<BareNumber>& numbers) {
  std::vector<Warning> warnings;
  for (const auto& [key, value, place] : numbers)
    for (const Usual& usual : usual_numbers) {
      if (key != usual.key || value == 0 || (value >= usual.least && value < usual.most)) continue;
      const std::string number = to_text(value);
      warnings.push_back(
          {place, fmt::format("{} {} {}: a bare number is in {}; if {} are meant, write \"{} {}\"",
                              key, number, usual.unit, usual.words, usual.other_unit, number,
                              usual.other_unit)});
    }
  return warnings;
}

}  // namespace vcrit
