// v* against the border that motion alone shows. Neither of its witnesses knows the harmonic
// balance: motion between events in closed form, and integration in small steps, which shares
// nothing with it but the numbers of the system.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "answers/critical_onset.hpp"
#include "compare/scene_report.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// What a comparison with v* has as its reference where that is not Eq. 24.
inline constexpr const char* simulated_reference = "v* by the slowest steady sliding";

/// What is said of the border between stick-slip and sliding.
struct Border {
  double contact_velocity = 0;  ///< v*, m/s
  double drive_velocity = 0;    ///< there, m/s; larger only where a network on the path creeps
  double condition = 0;         ///< condition number of Eq. 24 there
  std::string reference;        ///< who says so
  double uncertainty = 0;       ///< of v* to either side, m/s
  const char* why = "between which rounding leaves open whether it sticks";  ///< it is uncertain
};

/// Of a v* that is simulated: the condition of Eq. 24 says nothing of it.
Border simulated_border(const CriticalOnset& onset);

/// The last stick of starts at rest against v*.
Comparison compare_last_stick(const Border& border, const simulation::Onset& last_stick);
/// The same of the drive's velocity; none unless the path creeps.
std::optional<Comparison> compare_creep(const Border& border, const simulation::Onset& last_stick);

/// The one of these v* that is farthest from the last stick of starts at rest; none where none has
/// been found. condition: number of Eq. 24 there.
std::optional<Comparison> compare_evaluators(const std::vector<Comparison>& velocities,
                                             const simulation::Onset& last_stick, double condition);

/// Where v* is infinite: whether motion still sticks in each period at a speed far above all that
/// the scene has, in closed form and by a method other than that. Not run where none is found.
Comparison compare_stick_without_end(const Border& border, const simulation::System& system);
Comparison compare_march_without_end(const Border& border, const simulation::System& system);

/// By a method other than the exact one: a start at rest still sticks at 0.999 v* and slides at
/// 1.001 v*, or 0.99 and 1.01 v* where only fixed steps answer. Not run where none does.
Comparison compare_march(const Border& border, const simulation::System& system);

}  // namespace vcrit::validation
