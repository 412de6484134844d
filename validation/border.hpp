// v* against the border that motion alone shows. Neither of its witnesses knows the harmonic
// balance: motion between events in closed form, and integration in small steps, which shares
// nothing with it but the numbers of the system.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene_report.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// What is said of the border between stick-slip and sliding.
struct Border {
  double contact_velocity = 0;  ///< v*, m/s
  double drive_velocity = 0;    ///< there, m/s; larger only where a network on the path creeps
  double condition = 0;         ///< condition number of Eq. 24 there
  std::string reference;        ///< who says so
};

/// The last stick of starts at rest against v*.
Comparison compare_last_stick(const Border& border, const simulation::Onset& last_stick);
/// The same of the drive's velocity; none unless the path creeps.
std::optional<Comparison> compare_creep(const Border& border, const simulation::Onset& last_stick);

/// The one of these v* that is farthest from the last stick of starts at rest; none where none has
/// been found. condition: number of Eq. 24 there.
std::optional<Comparison> compare_evaluators(const std::vector<Comparison>& velocities,
                                             const simulation::Onset& last_stick, double condition);

/// By a method other than the exact one: a start at rest still sticks at 0.999 v* and slides at
/// 1.001 v*, or 0.99 and 1.01 v* where only fixed steps answer. Not run where none does.
Comparison compare_march(const Border& border, const simulation::System& system);

}  // namespace vcrit::validation
