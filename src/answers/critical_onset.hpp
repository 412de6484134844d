// The critical velocity of any scene: by Eq. (24) where the rulebook says that it holds, else by
// simulation.
#pragma once

#include <string>
#include <vector>

#include "critical/certified.hpp"
#include "problem/problem.hpp"

namespace vcrit {

namespace simulation {
class KnownModes;
}

struct CriticalOnset {
  /// The maximum over the phase of what sliding takes: below an indenter on a drive that gives.
  enum class By { formula, maximum_over_the_phase, simulation };
  By by = By::formula;
  double contact_velocity = 0;      ///< v*, m/s
  double drive_velocity = 0;        ///< m/s; larger only where a network on the path creeps
  double relative_error_bound = 0;  ///< of v*; of a simulated one NaN: none is known
  std::string reason;               ///< why v* is infinite, else empty
  /// m/s, of a body that swings freely at harmonics n > 1 of the oscillation, K_d = m (n omega)^2
  /// without damping: friction is full from a lower speed on (base/free_swings.hpp), NaN where that
  /// is not known; else v*.
  double sliding_from = 0;
  std::vector<int> free_harmonics = {};  ///< these n, increasing
  /// Of a v* that is not Eq. (24): an estimate of what rounding takes, and below a measured drive
  /// of what the structure fitted to its table may be off.
  double relative_error = 0;
};

/// "formula", "maximum over the phase", "simulation": names that stay the same, for programs.
const char* to_text(CriticalOnset::By by);

/// Those n of a scene whose contact stays closed, K_d and m (n omega)^2 being equal but for
/// rounding. Throws InputError for missing values.
std::vector<int> free_harmonics(const Problem& problem);

/// From what part of v* on sliding is steady with free swings at these harmonics; NaN where that is
/// not known.
double sliding_share(const std::vector<int>& free_harmonics);

/// Of a drive with masses by the memory of modes, if there is one. Throws InputError for missing
/// values, ModelError where v* is 0/0 and outside the model.
CriticalOnset critical_onset(const Problem& problem, simulation::KnownModes* known = nullptr);

/// v* alone, with its bound, NaN where it is simulated, and why it is infinite. Throws likewise.
CertifiedVelocity certified_onset(const Problem& problem);

/// v* alone at another angular frequency (rad/s), for loops: where it is Eq. (24), in doubles.
/// Throws likewise.
double quick_onset(const Problem& problem, double omega);

/// (p/v*) dv*/dp of that v* as log_derivative.hpp has it of Eq. (24); where v* is simulated, by
/// differences of it, right to some 1e-9 where it does not bend nearby. Throws as both do, and
/// ModelError where fewer than three digits are known.
double onset_log_derivative(const Problem& problem, const Symbol& symbol);

}  // namespace vcrit
