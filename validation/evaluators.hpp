// v* of a scene by the two ways that symbolic algebra gives: the derived formula evaluated with 50
// digits, and the generated evaluator, compiled and run as a program of its own.
#pragma once

#include <filesystem>
#include <string>

#include "derivation/derivation.hpp"
#include "scene/scene.hpp"

namespace vcrit::validation {

/// The derived formula at the scene's doubles, which stand for exactly themselves; 50 digits, then
/// rounded to a double. Throws std::runtime_error where the formula has no finite value.
double derived_velocity(const Scene& scene, const symbolic::Derivation& derivation,
                        const Values& values);

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
