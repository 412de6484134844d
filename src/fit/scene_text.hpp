// A fitted series as a scene file, ready for `derive` and `generate`, and for the other commands
// once the quantities that no measurement of stiffness gives are filled in.
#pragma once

#include <string>

#include "fit/fit.hpp"

namespace vcrit::fit {

/// What the user says of the rest of the scene, as written in a scene file ("20 kHz"); empty: a
/// symbol, with a commented line to fill in.
struct Rest {
  std::string title, poisson, frequency, amplitude, indentation, coefficient;
};

/// TOML. Throws InputError, naming the option, for a quantity of the wrong dimension.
std::string scene_text(const Fit& fit, const StiffnessTable& data, const Rest& rest);

}  // namespace vcrit::fit
