// v* by each way that is not the simulation, against the certified value.
#pragma once

#include <string>

#include "compare/scene_report.hpp"
#include "run/driver.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// Relative roundings of doubles.
inline constexpr double unit_roundoff = 0x1p-53;

/// What a comparison with Eq. 24 itself has as its reference.
inline constexpr const char* formula_reference = "Eq. 24, certified";

/// A comparison of a velocity with report.velocity_of_doubles, still without its value.
Comparison velocity_comparison(const SceneReport& report, const char* key, const char* name);

Comparison not_run(Comparison comparison, const std::string& why);
Comparison broken(Comparison comparison, const std::string& why);

/// A speed that something can move at: not at an exact resonance or antiresonance.
bool is_speed(double velocity);

/// Why there is no tolerance where the condition number is infinite.
inline constexpr const char* lost_digits =
    "at (anti)resonance, or where the drive does not give at all, doubles promise nothing";

/// Of a value computed in doubles: 32 rounding errors, each grown by the condition number.
Comparison in_doubles(const SceneReport& report, const char* key, const char* name, double found);

/// Of the formula as derived, evaluated with 50 digits.
Comparison derived_comparison(const SceneReport& report, const symbolic::Derivation& derivation,
                              const Values& values);

/// Of each call of the generated evaluator, compiled by the first compiler on the PATH, which goes
/// into the report.
void compare_generated(SceneReport& report, Driver& driver, const Values& values);

}  // namespace vcrit::validation
