// v* of a scene by the two ways that symbolic algebra gives: the derived formula evaluated with 50
// digits, and the generated evaluator, compiled and run as a program of its own.
#pragma once

#include <filesystem>
#include <string>

#include "derivation/derivation.hpp"
#include "scene/scene.hpp"

namespace vcrit::validation {

/// Digits that suffice wherever v* is not extremely near a resonance or antiresonance.
constexpr long usual_digits = 50;

/// A formula's value at doubles, which stand for exactly themselves, in so many digits, then
/// rounded to a double; `definitions` as for symbolic::value_at. Throws std::runtime_error where it
/// has no finite real value.
double value_in_digits(const GiNaC::ex& formula, const std::vector<symbolic::Line>& definitions,
                       const Values& values, long digits);

/// The derived formula in that way, at the scene's doubles.
double derived_velocity(const Scene& scene, const symbolic::Derivation& derivation,
                        const Values& values, long digits = usual_digits);

/// What the generated library answers, each call of its interface once; m/s.
struct GeneratedVelocities {
  double accurate = 0;
  double batch = 0;  ///< the call over many angular frequencies, at the scene's one
  double fast = 0;
  double certified = 0, certified_bound = 0;  ///< the bound is relative
};

/// Writes the scene's library to `folder`, compiles a program with it there and runs it. Throws
/// std::runtime_error, with what the compiler or the program said, when that does not work.
GeneratedVelocities generated_velocities(const Scene& scene, const symbolic::Derivation& derivation,
                                         const Values& values,
                                         const std::filesystem::path& compiler,
                                         const std::filesystem::path& folder);

/// The program that asks the library, as C++.
std::string asking_program(const std::vector<Symbol>& parameters, const Values& values);

}  // namespace vcrit::validation
