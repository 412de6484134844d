// When a contact that opens does so and when it closes, and what of the friction bound decays
// while it is closed. It does not depend on what the contact does along the surface.
#pragma once

#include "normal/normal_force.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// Times and forces as in model.hpp.
struct Opening {
  /// whole: see normal_cycle.hpp.
  Opening(const NormalMotion& motion, double omega, SharedEffort* whole = nullptr);

  struct Touch {
    double begin = 0;  ///< [0, 2 pi)
    double duration = 0;
    Vector decaying;  ///< parts of b at its begin
  };

  /// The contact does not open, or rounding hides it; no touches are listed then.
  bool closed = false;
  double mean_force = 0;  ///< N
  double error = 0;       ///< estimate of its relative error
  double constant = 0;    ///< part of b
  double amplitude = 0, phase = 0;
  bool jumps = false;  ///< F_n jumps up where the contact closes: a direct damper
  /// A part of the normal network that answers at once is left out. Friction does not notice it; v*
  /// does, as the contact point is pushed by all of the force with which the contact closes.
  bool answers_at_once = false;
  Vector rates;  ///< of the decaying parts
  List<Touch, 2> touches;

  /// From t to where the contact opens in a touch, or closes for it; 0 where t is there within
  /// rounding.
  double until_opened(Index touch, double t) const;
  double until_closed(Index touch, double t) const;
  /// A decaying part of b at a time of its touch, or the sum of the derivatives of all of them.
  double part(Index i, Index touch, double t) const;
  double decaying(Index touch, double t, int derivative) const;
  /// The middle of the longest separation, and the touch that ends it.
  struct Middle {
    double time = 0;
    Index next = 0;
  };
  Middle middle() const;
};

}  // namespace vcrit::simulation
