// What vibration does to the friction of a scene: up to which speed, by how much, and how far the
// contact stays closed. A record; effect_words.hpp says it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "answers/critical_onset.hpp"
#include "problem/problem.hpp"

namespace vcrit::record {
class Fields;
}

namespace vcrit {

struct Effect {
  enum class Kind {
    lowers,      ///< below a finite speed
    never,       ///< v* = 0
    all_speeds,  ///< v* is infinite
    outside,     ///< the model has no answer
  };
  Kind kind = Kind::lowers;

  double frequency = 0, amplitude = 0;           ///< Hz, m: of the vibrator
  bool of_vibrator = false;                      ///< whose amplitude that is, above a mount
  std::optional<double> contact_amplitude = {};  ///< m, below a mount, where it is harmonic
  /// m; under a load as found, nothing where it is not known.
  std::optional<double> indentation = {};
  std::optional<double> sinking_velocity = {};  ///< m/s, under a load that no spring carries
  bool under_load = false;                      ///< the scene gives the mean normal force
  double friction_coefficient = 0;              ///< mu0
  /// N: the load, or K_n(0) u_z0; of a contact that opens, and below an indenter, of the motion.
  /// Nothing where that is not known.
  std::optional<double> mean_normal_force = {};
  /// m; below an indenter that of the centre. Nothing where the contact opens at every amplitude.
  std::optional<double> largest_closed_amplitude = {};
  bool below_indenter = false;
  bool opens = false;  ///< in every period, as the scene allows

  // Not of a scene that is outside.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double critical_velocity = unknown;  ///< v*, m/s, of the contact point
  double drive_velocity = unknown;     ///< m/s; above v* by the creep of the path
  /// m/s, of the drive: friction is full from here on. Less than drive_velocity of an undamped body
  /// that swings freely at a harmonic, NaN where that is not known.
  double reduced_below = unknown;
  bool simulated = false;                 ///< v* is, or a maximum over the phase; else Eq. (24)
  bool by_phase = false;                  ///< as a maximum over the phase
  double relative_error_bound = unknown;  ///< of Eq. (24): rounding
  double relative_error = unknown;        ///< of a simulated v*, an estimate
  std::string why_infinite = {};

  /// Lowest mu/mu0: the limit at rest, as friction never falls with the speed (docs/physics.md).
  std::optional<double> lowest = {};
  std::string why_no_lowest = {};  ///< where friction is not computed

  std::vector<std::string> reasons = {};  ///< why the scene is outside, as the rulebook says

  bool creeps() const { return drive_velocity > critical_velocity; }
  /// Whether the scene is outside since its contact would open.
  bool would_open() const {
    return kind == Kind::outside && largest_closed_amplitude &&
           !(amplitude < *largest_closed_amplitude);
  }

  friend void fields(record::Fields& f, const Effect& it);
};

/// "lowers", "never", "all_speeds", "outside": names that stay the same, for programs.
const char* to_text(Effect::Kind kind);

/// What is known without v*: the operating point, and whether the scene is outside. Throws
/// InputError for missing values.
Effect without_velocities(const Problem& problem);

/// The amplitude (m) at which the contact opens, below an indenter at its centre; nothing where it
/// does at every one. Throws InputError for missing values.
std::optional<double> largest_closed_amplitude(const Problem& problem);

/// Throws InputError for missing values, ModelError where v* is 0/0 of a scene that is not outside.
Effect effect_of(const Problem& problem);
/// The same of v* that is known already.
Effect effect_of(const Problem& problem, const CriticalOnset& onset);

}  // namespace vcrit
