// The steady normal force of a contact that opens, F = max(0, reaction of the normal network),
// without adhesion: while the contact is closed, the network's deformation is the indentation and
// its Maxwell branches relax on their own; while it is open, it carries no force and its Kelvin
// units creep back on their own, until the contact closes again.
#pragma once

#include <complex>

#include "normal/normal_stays.hpp"

namespace vcrit::simulation {

/// One period of the steady force, in units of the network's stiffness times the length.
struct NormalCycle {
  /// F = Re(swing e^{it}) + sum_i decays_i e^{-rate_i (t - begin)}, rates those of the network's
  /// branches; 0 between one touch and the next.
  struct Touch {
    double begin = 0;  ///< [0, 2 pi)
    double duration = 0;
    Vector decays;
  };

  double mean = 0;
  double error = 0;  ///< estimate of the mean's absolute error
  std::complex<double> swing;
  List<Touch, 2> touches;  ///< by time; none where the contact never closes
};

/// The network with time in units of 1/omega; a spring carries its static load. Where it does not
/// open, or hardly, so that rounding hides it, the cycle is one touch over the whole period, with
/// what it would pull as the error. Throws ModelError where no closed cycle is found, and beyond
/// effort_of_normal_force, or that of `whole`, if there is one.
NormalCycle normal_cycle(const ContactModes& network, const Indentation& indentation,
                         SharedEffort* whole = nullptr);

/// The same, and what the mean force changes by with the mean indentation, from 0 (where the
/// contact never closes) to the spring's stiffness (where it never opens).
struct PressedCycle {
  NormalCycle cycle;
  double slope = 0;
};
PressedCycle pressed_cycle(const ContactModes& network, const Indentation& indentation,
                           SharedEffort* whole = nullptr);

/// A few seconds: enough for some hundred branches.
inline constexpr std::size_t effort_of_normal_force = 200'000'000;

}  // namespace vcrit::simulation
