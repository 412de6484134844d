// The equations of motion as one linear ODE for each of slip, stick and backslip, for general
// integrators: y' = A y + p + q cos t + r sin t. Written down from springs, dampers and Maxwell
// branches as they stand, with no mode, no retardation form and nothing else of the exact
// simulator.
//
// Without dimension: time 1/omega, force mu0 <F_n>, velocity omega (force)/|K_t(i omega)|. States:
//   contact spring force, contact branch forces | drive spring force, drive branch forces |
//   body velocity | impulse, the time integral of the contact force
// and only those that the system has. Elongation e of the contact, d of the drive, body velocity u:
//   F = k0 e + c e' + sum q_j,   q_j' = k_j e' - q_j/tau_j,   the same with d for the drive force,
//   d' = v - u,   m u' = F_d - F,   contact velocity w = u - e'.
// Stick: e' = u. Slip: F = +-b(t); then c e' = F - k0 e - sum q_j is one ODE, and without a damper
// K_g e' = F' + sum q_j/tau_j with the glassy stiffness K_g, its constraint differentiated once.
// A massless body has F_d = F in place of Newton's law, solved in the same two ways.
#pragma once

#include <Eigen/Core>

#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulators {

/// A quantity linear in (states, 1, cos t, sin t).
using Row = Eigen::RowVectorXd;

struct LinearMotion {
  Eigen::MatrixXd rates;  ///< one row a state: its time derivative
  Row force;              ///< of the contact network on the contact point
  Row contact_velocity;   ///< w; zero in stick
};

class SwitchedSystem {
 public:
  /// velocity: of the drive, m/s.
  SwitchedSystem(const simulation::System& system, double velocity);

  Eigen::Index states() const { return states_; }  ///< the impulse is the last one
  const LinearMotion& motion(simulation::Motion motion) const;

  /// (y, 1, cos t, sin t), to be multiplied by rows.
  Eigen::VectorXd extended(const Eigen::VectorXd& y, double t) const;
  double bound(double t) const;  ///< b(t) > 0
  /// d/dt of a quantity along a motion.
  double rate(const Row& quantity, simulation::Motion motion, const Eigen::VectorXd& y,
              double t) const;

  /// Shifts the forces of networks without a damper onto `force`, which they carry exactly but
  /// integrated rates only to rounding and tolerance.
  void project(Eigen::VectorXd& y, double force) const;

  /// At rest, nothing deformed.
  Eigen::VectorXd at_rest() const { return Eigen::VectorXd::Zero(states_); }
  /// The motion that the state is in when it may stick: stick unless that takes more than b.
  simulation::Motion motion_of(const Eigen::VectorXd& y, double t) const;

 private:
  struct SwitchedNetwork {
    double spring = 0, damper = 0;
    std::vector<MaxwellBranch> branches;
    Eigen::Index first = 0;  ///< its first state
    Eigen::Index size() const;
    double glassy() const;
  };
  SwitchedNetwork scaled(const Relaxation& form, Eigen::Index first) const;
  Row unit(Eigen::Index column) const;
  Row elastic(const SwitchedNetwork& network) const;   ///< k0 e + sum q_j
  Row relaxing(const SwitchedNetwork& network) const;  ///< sum q_j/tau_j
  Row elongation_rate(const SwitchedNetwork& network, const Row& force,
                      const Row& force_rate) const;
  Row stuck_body_velocity() const;
  LinearMotion slipping(double sign) const;
  LinearMotion sticking() const;
  void set_rates(LinearMotion& motion, const Row& elongation_rate, const Row& body) const;
  void set_network(Eigen::MatrixXd& rates, const SwitchedNetwork& network, const Row& rate) const;
  void project(Eigen::VectorXd& y, const SwitchedNetwork& network, double force) const;

  double force_unit_, velocity_unit_, omega_;
  double velocity_;  ///< of the drive
  double mass_ = 0;
  bool has_drive_, has_body_;
  SwitchedNetwork contact_, drive_;
  Eigen::Index states_ = 0;
  Row bound_, bound_rate_;
  LinearMotion slip_, stick_, backslip_;
};

}  // namespace vcrit::simulators
