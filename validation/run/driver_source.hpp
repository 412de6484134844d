// The driver program as C++.
#pragma once

#include <string>
#include <vector>

#include "run/driver.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// A way as statements over `sets`, `columns`, `omegas` and `out`.
struct Call {
  Way way;
  std::string values;
  std::string timed;       ///< what is timed, if it is something else
  bool unhurried = false;  ///< its time is of no interest
};

/// The calls of the generated library "scene".
const std::vector<Call>& generated_calls();
/// Eq. 24 in complex numbers, and the derived formula, as they stand in the text.
const Call& complex_call();
const Call& pasted_call();

/// Of the formula as `vcrit derive` prints it, of which the parameters are read in their order, and
/// with its networks as complex stiffnesses. With the generated library "scene" if there is one.
std::string driver_source(const symbolic::Derivation& formula, bool has_generated);

}  // namespace vcrit::validation
