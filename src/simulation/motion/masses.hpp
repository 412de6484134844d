// A body on a drive that holds masses, without dimensions (model.hpp): the motion of
// stiffness/drive_motion.hpp in place of u and the g_j, x_b = (u, x_2, ..., x_n), all of them
// velocities with the energy m |x_b|^2/2.
#pragma once

#include <complex>

#include "modes/contact_modes.hpp"
#include "modes/general_modes.hpp"
#include "stiffness/drive_motion.hpp"

namespace vcrit::simulation {

struct Masses {
  /// stiffness_unit: N/m, of the model.
  Masses(const DriveMotion& motion, double omega, double stiffness_unit);

  Index states() const { return rest.size(); }

  double mass = 0;               ///< of the body's end
  double fluidity = 0;           ///< its velocity under a constant force of 1; 0 with a spring
  double frequency = 0;          ///< rad/s, of the oscillation
  Dense<long double> by_second;  ///< A (1/s), the same at all frequencies
  Dense<long double> exact;      ///< A
  Matrix rates;                  ///< A, rounded
  Matrix losses;  ///< -(A + A^T)/2: x.losses x times the mass is the power of the drive's dampers
  Vector steady;  ///< x_b under a constant force of 1
  Vector rest;    ///< x_b where everything moves by 1
};

/// Of the drive alone, its force given; by the memory of modes, if there is one.
GeneralModes slip_modes(const Masses& masses, KnownModes* known);
/// Of y = (x_b', rho) of the drive and a contact that sticks to ground.
GeneralModes stick_modes(const Masses& masses, const ContactModes& contact, KnownModes* known);

/// x_b' for x_b and a force on the body's end.
void add_rates(const Masses& masses, ConstView x, double force, View y);

/// Velocity of the body's end for a force on it, s as of e^{st}.
std::complex<double> mobility(const Masses& masses, std::complex<double> s);

/// The mass of the mode that is in resonance with the oscillation, as its end sees it.
double resonant_mass(const Masses& masses);

}  // namespace vcrit::simulation
