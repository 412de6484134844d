// How a load presses the contact, and how a mount moves it: what a scene does not say and its
// answers do.
#pragma once

#include <optional>

#include "problem/problem.hpp"

namespace vcrit::record {
class Fields;
}

namespace vcrit {

struct UnderLoad {
  /// u_z0, m, below 0 where the contact is open for most of the time. Nothing where it sinks, and
  /// where it is not found.
  std::optional<double> indentation = {};
  double mean_normal_force = 0;                 ///< N
  std::optional<double> sinking_velocity = {};  ///< m/s, of a normal network that creeps

  /// Its keys stand among those of an answer.
  friend void fields(record::Fields& f, const UnderLoad& it);
};

/// Nothing of a scene whose indentation is given, but for one with a mount. Throws InputError for
/// missing values.
std::optional<UnderLoad> under_load(const Problem& problem);

/// How the contact oscillates below a mount.
struct BelowMount {
  double amplitude = 0;  ///< du_z, m
  double mount_phase =
      0;  ///< rad, of the contact's height against the vibrator's, below 0 behind it

  /// Its keys stand among those of an answer.
  friend void fields(record::Fields& f, const BelowMount& it);
};

/// Nothing of a scene without a mount, and of a contact that opens below one. Throws InputError for
/// missing values.
std::optional<BelowMount> below_mount(const Problem& problem);

/// du_z, m, with and without a mount. Throws ModelError where the contact opens below one,
/// InputError for missing values.
double amplitude_at_contact(const Problem& problem);

/// <F_n>, N, of any scene: what `vcrit sweep` asks for. Throws ModelError where it is not found,
/// InputError for missing values.
double mean_normal_force_of(const Problem& problem);

}  // namespace vcrit
