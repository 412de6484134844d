// Periodic motion of a closed contact on a grid of one period, for scenes that no march in time
// knows: drives with masses or measured, springs with a loss factor, v* = 0 or infinity. Friction F
// and the velocity w of the contact point are unknown at each point of the grid together,
//
//   F = mu0 F_n - x,  w = v0 - (i n omega H(i n omega) F_n),  x >= 0,  w >= 0,  x w = 0,
//
// with the networks' answer H at all harmonics n of the grid (nodal_response.hpp). The search
// begins with a contact that sticks at all times. What it shares with Eq. 24 is that networks are
// linear; where sticks end it learns from motion with sticks in it.
#pragma once

#include <vector>

#include "compare/nodal_response.hpp"
#include "compare/scene_report.hpp"

namespace vcrit::validation {

class PeriodicMotion {
 public:
  /// Throws InputError for missing values, ModelError for networks of too many points.
  explicit PeriodicMotion(const Problem& problem);

  /// By how much friction falls short of mu0 F_n in the mean, N, where the contact point moves at
  /// this mean speed (m/s) and never backward. Throws ModelError where no motion is found.
  double missing_friction(double velocity) const;

  /// The speed at which sticks end, to 1e-6 of it: 0 where none lasts at a part in 1e17 of the
  /// speed that the contact's own stiffness gives, infinite where they last at 1e8 times that.
  double border() const;
  /// The highest border that is told from none, m/s.
  double highest() const;
  /// The lowest one that rounding leaves as many digits as resolution(), m/s.
  double lowest() const;

  /// What of the border, as a share, the grid leaves open: half a step from its slowest instant.
  static double resolution();

 private:
  std::vector<double> lost(double velocity) const;  ///< x over the amplitude of mu0 F_n

  double amplitude_;            ///< of mu0 F_n, N
  double unit_;                 ///< speed that it gives the contact under a body at rest, m/s
  bool swings_freely_ = false;  ///< at some harmonic
  std::vector<double> push_;    ///< velocity that mu0 F_n gives, over the grid, in these units
  std::vector<double> kernel_;  ///< velocity that x at the grid's first point gives
};

/// v* of the report against that border.
Comparison compare_periodic_motion(const SceneReport& report);

}  // namespace vcrit::validation
