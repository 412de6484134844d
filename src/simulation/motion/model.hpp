// A system without dimensions: time 1/omega, force mu0 <F_n>, stiffness |K(i omega)| of the path
// from drive to contact point (or of the contact, with a body); t = 0 where F_n is largest, so that
// the friction bound is b(t) = 1 + amplitude cos t. States are only those that the system has:
// without a mass, contact and drive are one network in series, and nothing else moves.
//
//   state  x = (F | u, g_1..g_M | contact),   rates  y = (u', g_1'..g_M' | contact)
//   contact: r in slip; rho and r in stick, of which y has rho alone
//
// F force of the contact on the contact point, u body velocity less drive velocity, g_j the drive's
// branch forces taken negative (g_j' = k_j u - a_j g_j), contact as in contact_modes.hpp.
#pragma once

#include <complex>
#include <optional>

#include "simulation/modes/contact_modes.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

struct Body {
  double mass = 0;
  PoleSum drive;        ///< K_d(s)/s
  double fluidity = 0;  ///< 1/eta of a drive that creeps, else 0
};

/// One kind of motion: its modes, and what they do, by modal coordinates.
struct Phase {
  Modes modes;
  Matrix levels;  ///< rates of the levels: F (in stick), u, g_j
  Matrix own;     ///< the contact's part of y
  Vector event;   ///< stick: F'; slip: contact acceleration
};

/// A time with its place in the oscillation.
struct Instant {
  Instant(double t) : time(t), turn(std::cos(t), std::sin(t)) {}

  double time;
  std::complex<double> turn;  ///< e^{it}
};

struct Model {
  explicit Model(const System& system);

  double amplitude = 0;      ///< of b(t); < 1
  double phase = 0;          ///< t = omega t_physical + phase
  double force_unit = 0;     ///< N
  double velocity_unit = 0;  ///< m/s
  ContactModes contact;
  std::optional<Body> body;
  Phase stick, slip;

  /// Response to b(t) in steady forward sliding: amplitudes of e^{it} of y and of the contact
  /// velocity, and the mean of drive velocity less contact velocity.
  List<std::complex<double>> sliding_rates;
  std::complex<double> sliding_velocity;
  double creep = 0;
  /// How many times the forces on the body are larger than their sum; infinite at an undamped
  /// resonance of body and drive. As many times rounding errors grow.
  double resonance = 1;

  Index body_states() const { return body ? 1 + body->drive.rates.size() : 0; }  ///< u, g_j
  Index branches() const { return contact.branch_stiffness.size(); }
  Index units() const { return contact.unit_fluidity.size(); }
  Index level_states() const { return 1 + body_states(); }
  Index slip_states() const { return level_states() + units(); }
  Index stick_states() const { return level_states() + branches() + units(); }

  /// Integrals are kept of F, u and what relaxes over more than one radian, slow branches of the
  /// drive and slow units of the contact: what these change by in a period is no more than a
  /// rounding error of what they are.
  Index slow_branches = 0, slow_units = 0;
  Index integrated_levels() const { return body ? 2 + slow_branches : 1; }
  Index integrals() const { return integrated_levels() + slow_units; }

  double bound(const Instant& t) const { return 1 + amplitude * t.turn.real(); }
  double bound_rate(const Instant& t) const { return -amplitude * t.turn.imag(); }
  double bound_curvature(const Instant& t) const { return -amplitude * t.turn.real(); }

  /// y from x, or a change of y from a change of x.
  void rates(ConstView x, bool stuck, View y) const;

 private:
  void set_stick();
  void set_slip();
  void set_sliding();
};

}  // namespace vcrit::simulation
