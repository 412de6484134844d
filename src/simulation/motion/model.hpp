// A system without dimensions: time 1/omega, force mu0 <F_n>, stiffness |K(i omega)| of the path
// from drive to contact point (or of the contact, with a body); t = 0 where the harmonic part of
// F_n is largest, so that the friction bound is b(t) = 1 + amplitude cos t, or, of a contact that
// opens, mean + amplitude cos t + sum_i q_i with q_i' = -a_i q_i while the contact is closed.
// States are only those that the system has: without a mass, contact and drive are one network in
// series, and nothing else moves.
//
//   state  x = (F | u, g_1..g_M | contact),   rates  y = (u', g_1'..g_M' | contact)
//   contact: r in slip; rho and r in stick, of which y has rho alone
//
// F force of the contact on the contact point, u body velocity less drive velocity, g_j the drive's
// branch forces taken negative (g_j' = k_j u - a_j g_j), contact as in contact_modes.hpp. All less
// what they are in steady sliding under a constant bound `load`, as the velocity of a motion is
// that of the contact there: of a contact that never opens the mean bound, so that the numbers of a
// state are as small as the oscillation, and as exact; of one that opens 0.
#pragma once

#include <complex>
#include <optional>

#include "modes/contact_modes.hpp"
#include "simulation/motion/masses.hpp"
#include "simulation/motion/opening.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

struct Body {
  double mass = 0;
  PoleSum drive;                      ///< K_d(s)/s; nothing where the drive holds masses
  double fluidity = 0;                ///< 1/eta of a drive that creeps, else 0
  std::optional<Masses> masses = {};  ///< then x_b is in place of (u, g_j)

  /// Velocity for a force on it, s as of e^{st}.
  std::complex<double> mobility(std::complex<double> s) const;
};

/// `amplitude` cos(n t), t from the slowest instant of sliding.
struct FreeSwing {
  int harmonic = 0;
  double amplitude = 0;
};

/// One kind of motion: its modes, and what they do, by modal coordinates.
struct Phase {
  Modes modes;
  Matrix levels;  ///< rates of the levels: F (in stick), u, g_j
  Matrix own;     ///< the contact's part of y
  Vector event;   ///< stick: F'; slip: contact acceleration
  Vector bound;   ///< stick, of a contact that opens: rate of the decaying parts of b
};

/// A time with its place in the oscillation.
struct Instant {
  Instant(double t) : time(t), turn(std::cos(t), std::sin(t)) {}

  double time;
  std::complex<double> turn;  ///< e^{it}
};

struct Model {
  explicit Model(const System& system);

  double mean = 1;           ///< of b(t), without what decays
  double amplitude = 0;      ///< of b(t); < 1 unless the contact opens
  double load = 0;           ///< from which F is measured
  double phase = 0;          ///< t = omega t_physical + phase
  double normal_force = 0;   ///< mean, N
  double force_unit = 0;     ///< N
  double velocity_unit = 0;  ///< m/s
  ContactModes contact;
  std::optional<Body> body;
  std::optional<Opening> opening;  ///< where the contact opens
  Phase stick, slip;

  /// Response to b(t) in steady forward sliding: amplitudes of e^{it} of y and of the contact
  /// velocity, and the mean of drive velocity less contact velocity.
  List<std::complex<double>> sliding_rates;
  std::complex<double> sliding_velocity;
  double creep = 0;
  /// How many times body and drive give way more at e^{it} than at e^t, where all their forces have
  /// one sign and nothing cancels, however stiff a part is; infinite at an undamped resonance of
  /// both. As many times rounding errors grow.
  double resonance = 1;
  /// How many times a damper on the body of a drive with masses is stiffer at e^t than all of it:
  /// in doubles as many times the rounding of its force is felt.
  double unlike = 1;
  int free_harmonic = 0;  ///< see system.hpp
  mutable Effort effort;  ///< left for the present search
  /// Of a contact that never opens, the least velocity of steady sliding: the amplitude of the
  /// contact velocity. A body that swings freely at the n-th harmonic, n > 1, may take off that
  /// swing's part of it, down to cos(pi/(2 n)): a measure on the two instants +-pi/(2 n) gives no
  /// such swing a mean, and the free swing attains it. Masses may have several (free_swings.hpp).
  double threshold = 0;
  double threshold_error = 0;  ///< what rounding takes of a drive with masses, an estimate
  List<FreeSwing, 1> free_swings;
  /// Share that modes of masses which merge may take of all answers, and by how much they let
  /// rounding errors grow, 1 where they are apart (general_modes.hpp).
  double merging = 0, amplification = 1;

  /// u and g_j, or those of the masses.
  Index body_states() const {
    if (!body) return 0;
    return body->masses ? body->masses->states() : 1 + body->drive.rates.size();
  }
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

  /// b(t) while the contact is closed.
  double bound(const Instant& t, Index touch = 0) const { return mean + swing(t, touch); }
  /// F of slip forward (side = 1) or backward (-1), less the load.
  double slip_force(int side, const Instant& t, Index touch = 0) const {
    return (side * mean - load) + side * swing(t, touch);
  }
  double bound_rate(const Instant& t, Index touch = 0) const {
    return -amplitude * t.turn.imag() + decaying(t, touch, 1);
  }
  double bound_curvature(const Instant& t, Index touch = 0) const {
    return -amplitude * t.turn.real() + decaying(t, touch, 2);
  }

  /// What forces change by: b(t) of a contact that never opens by its amplitude, else all of it.
  double force_size() const { return opening ? 1 : amplitude; }

  /// Of a contact that never opens: whether its steady motion is sliding without end, and whether
  /// it is none, as a path that creeps carries F = eta v0 below the bound. velocity: of a motion.
  bool slides(double velocity) const { return !opening && velocity >= threshold; }
  bool never_slips(double velocity) const { return !opening && velocity <= -creep * amplitude; }

  /// The velocity of a motion, of that of the drive.
  double motion_velocity(double drive_velocity) const { return drive_velocity - creep * load; }

  /// Adds so many times what steady sliding under a constant bound of 1 has to x = (F | u, g_j).
  void add_steady(double times, View x) const;

  /// Estimate of the relative error of <F_n>.
  double bound_error() const { return opening ? opening->error : closed_error_; }

  /// y from x, or a change of y from a change of x.
  void rates(ConstView x, bool stuck, View y) const;

 private:
  double swing(const Instant& t, Index touch) const {
    return amplitude * t.turn.real() + decaying(t, touch, 0);
  }
  double decaying(const Instant& t, Index touch, int derivative) const {
    if (!opening) [[likely]]
      return 0;
    return opening->decaying(touch, t.time, derivative);
  }
  double closed_error_ = 0;  ///< what a contact taken for closed leaves out by not opening

  void set_bound(const System& system);
  void set_free_swings(const System& system);
  void set_sliding_of_masses();
  const Modes& heard(const GeneralModes& found);
  void set_stick(KnownModes* known);
  void set_slip(KnownModes* known);
  void set_sliding();
};

}  // namespace vcrit::simulation
