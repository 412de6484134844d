// v* of a scene by the two ways that symbolic algebra gives: the derived formula evaluated with 50
// digits, and the generated evaluator, as the driver program runs it.
#pragma once

#include "derivation/derivation.hpp"
#include "problem/problem.hpp"
#include "run/driver.hpp"

namespace vcrit::validation {

/// Digits that suffice wherever v* is not extremely near a resonance or antiresonance.
constexpr long usual_digits = 50;

/// A formula's value at doubles, which stand for exactly themselves, in so many digits, then
/// rounded to a double; `definitions` as for symbolic::value_at. Throws std::runtime_error where it
/// has no finite real value.
double value_in_digits(const GiNaC::ex& formula, const std::vector<symbolic::Line>& definitions,
                       const Values& values, long digits);

/// The derived formula in that way, at the scene's doubles.
double derived_velocity(const symbolic::Derivation& derivation, const Values& values,
                        long digits = usual_digits);

/// What the generated library answers, each call of its interface once; m/s.
struct GeneratedVelocities {
  double accurate = 0;
  double batch = 0;  ///< the call over many angular frequencies, at the scene's one
  double fast = 0;
  double certified = 0, certified_bound = 0;  ///< the bound is relative
};

/// By a driver that is compiled and has the library, at the scene's doubles. Throws as its run().
GeneratedVelocities generated_velocities(const Driver& driver, const Values& values);

}  // namespace vcrit::validation
