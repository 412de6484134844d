// The equations of motion as they stand in a textbook, for methods that integrate them in time.
// Without dimensions: time 1/omega, force mu0 <F_n>, stiffness |K(i omega)| of the path from drive
// to contact point (of the contact, with a body); t = 0 where F_n is largest.
//
//   state  (u, forces of the drive's branches, forces of the contact's branches)
//   u      velocity of the body; the state has it and the drive only where there is a mass
//   f_j' = k_j e' - a_j f_j, a spring has a_j = 0; network force c e' + sum f_j
//   m u' = F_drive - F, and F on the contact point obeys Coulomb's law with its velocity w
// Of a drive that holds masses the state has those of driven_masses.hpp in place of u and the
// drive.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "simulation/methods/driven_masses.hpp"
#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation::methods {

struct Branch {
  double stiffness = 0;
  double rate = 0;  ///< 1/tau; 0 for a spring
};

struct Chain {
  double damper = 0;
  std::vector<Branch> branches;
  double glassy = 0;  ///< sum of the stiffnesses

  double sum(const double* forces) const;     ///< sum f_j
  double fading(const double* forces) const;  ///< sum a_j f_j
  void rates(const double* forces, double velocity, double* out) const;
  /// The branch that takes a correction of the force: the spring, else the stiffest.
  std::size_t main_branch() const;
};

struct DrivenBody {
  double mass = 0;
  Chain drive;
};

struct Equations {
  Equations(const System& system, double velocity);

  double velocity = 0;   ///< of the drive
  double amplitude = 0;  ///< of b(t) = 1 + amplitude cos t, mu0 F_n
  double phase = 0;      ///< t = omega t_physical + phase
  Chain contact;
  std::optional<DrivenBody> body;
  std::optional<DrivenMasses> masses;  ///< in place of the body

  std::size_t size() const;           ///< of a state
  std::size_t contact_begin() const;  ///< index of the contact's first branch
  /// The smallest rate above 0 at which a network relaxes, roughly.
  double slowest_rate() const;
  /// Typical size of each entry of the state: 1 for forces; velocities that move them as much.
  std::vector<double> scales() const;
  /// Body and contact unloaded and still, or about to slide: the drive under its mean load, the
  /// body as fast as the drive and the contact at the friction bound.
  std::vector<double> start(Start start) const;

  double bound(double t) const { return 1 + amplitude * std::cos(t); }
  double bound_rate(double t) const { return -amplitude * std::sin(t); }
  double bound_curvature(double t) const { return -amplitude * std::cos(t); }

  /// Of the upper end of the contact, under a drive velocity; the same of rates of the state.
  double top_velocity(const double* y, double drive_velocity) const {
    if (masses) return drive_velocity + masses->end_velocity(y);
    return body ? y[0] : drive_velocity;
  }
  const double* contact_forces(const double* y) const { return y + contact_begin(); }
  /// F of the contact when its point moves with w.
  double force(const double* y, double w) const {
    return contact.damper * (top_velocity(y, velocity) - w) + contact.sum(contact_forces(y));
  }
  /// dy/dt under a drive velocity, while the contact point moves with w and the contact's force
  /// is F: linear in all of them together.
  void rates(const double* y, double drive_velocity, double w, double force, double* dydt) const;

  /// Phase of the oscillation, omega t in [0, 2 pi), at time t.
  double phase_at(double t) const;
};

}  // namespace vcrit::simulation::methods
