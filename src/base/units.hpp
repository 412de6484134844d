// Quantities with units, converted to SI by udunits.
#pragma once

#include <string>
#include <string_view>

#include "base/errors.hpp"

namespace vcrit {

/// What a number measures, by its SI unit.
enum class Dimension {
  none,               ///< 1
  stiffness,          ///< N/m
  damping,            ///< N s/m
  modulus,            ///< Pa
  viscosity,          ///< Pa s
  time,               ///< s
  mass,               ///< kg
  length,             ///< m
  angle,              ///< rad
  velocity,           ///< m/s
  force,              ///< N
  frequency,          ///< Hz, cycles a second: "20 kHz" is 20000
  angular_frequency,  ///< rad/s; a frequency in Hz is refused, and the other way round
  compliance          ///< m/N
};

/// "a stiffness in N/m", for messages.
std::string describe(Dimension dimension);

/// "N/m"; "1" for a plain number.
const char* si_unit(Dimension dimension);

/// `text` is a number (SI) or a number and a unit ("8 N/um"). Returns the value in SI.
/// Throws InputError for bad syntax, unknown units and units of another dimension.
double parse_quantity(std::string_view text, Dimension dimension, const Place& place);

/// A number as it was typed: with a unit it is a decimal number, 0.1 um is 1e-7 m, which no double
/// is; a bare one is a double, as TOML has it.
struct TypedNumber {
  double value = 0;  ///< in SI, the double nearest to it
  /// "1e-7", exactly; empty for bare numbers, and where it is no short decimal one (rpm).
  std::string decimal = {};
  bool is_bare = false;   ///< without a unit
  std::string text = {};  ///< "0.1 um", as it was typed; empty for bare numbers
};
TypedNumber parse_typed(std::string_view text, Dimension dimension, const Place& place);

}  // namespace vcrit
