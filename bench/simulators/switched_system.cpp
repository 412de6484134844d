#include "simulators/switched_system.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace vcrit::simulators {

using Eigen::Index;
using Eigen::VectorXd;
using simulation::Motion;

Index SwitchedSystem::SwitchedNetwork::size() const {
  return static_cast<Index>(branches.size()) + (spring > 0 ? 1 : 0);
}

double SwitchedSystem::SwitchedNetwork::glassy() const {
  double sum = spring;
  for (const MaxwellBranch& branch : branches) sum += branch.stiffness;
  return sum;
}

SwitchedSystem::SwitchedSystem(const simulation::System& system, double velocity)
    : force_unit_(system.friction * system.mean_normal_force),
      velocity_unit_(system.omega * force_unit_ /
                     std::abs(dynamic_stiffness(system.contact, system.omega))),
      omega_(system.omega),
      velocity_(velocity / velocity_unit_),
      has_drive_(system.drive.has_value()),
      has_body_(system.drive && system.mass.value_or(0) > 0) {
  contact_ = scaled(system.contact, 0);
  states_ = contact_.size();
  if (has_drive_) {
    drive_ = scaled(*system.drive, states_);
    states_ += drive_.size();
  }
  if (has_body_) {
    mass_ = *system.mass * omega_ * velocity_unit_ / force_unit_;
    ++states_;
  }
  ++states_;
  const auto amplitude = system.normal_force_amplitude / system.mean_normal_force;
  bound_ =
      unit(states_) + amplitude.real() * unit(states_ + 1) - amplitude.imag() * unit(states_ + 2);
  bound_rate_ = -amplitude.imag() * unit(states_ + 1) - amplitude.real() * unit(states_ + 2);
  slip_ = slipping(1);
  stick_ = sticking();
  backslip_ = slipping(-1);
}

SwitchedSystem::SwitchedNetwork SwitchedSystem::scaled(const Relaxation& form, Index first) const {
  const double stiffness = velocity_unit_ / (omega_ * force_unit_);
  SwitchedNetwork network{form.equilibrium * stiffness, form.damper * stiffness * omega_,
                          form.branches, first};
  for (MaxwellBranch& branch : network.branches) {
    branch.stiffness *= stiffness;
    branch.time *= omega_;
  }
  return network;
}

const LinearMotion& SwitchedSystem::motion(Motion motion) const {
  if (motion == Motion::stick) return stick_;
  return motion == Motion::slip ? slip_ : backslip_;
}

Row SwitchedSystem::unit(Index column) const { return Row::Unit(states_ + 3, column); }

Row SwitchedSystem::elastic(const SwitchedNetwork& network) const {
  Row sum = Row::Zero(states_ + 3);
  sum.segment(network.first, network.size()).setOnes();
  return sum;
}

Row SwitchedSystem::relaxing(const SwitchedNetwork& network) const {
  Row sum = Row::Zero(states_ + 3);
  Index column = network.first + (network.spring > 0 ? 1 : 0);
  for (const MaxwellBranch& branch : network.branches) sum(column++) = 1 / branch.time;
  return sum;
}

Row SwitchedSystem::elongation_rate(const SwitchedNetwork& network, const Row& force,
                                    const Row& force_rate) const {
  if (network.damper > 0) return (force - elastic(network)) / network.damper;
  return (force_rate + relaxing(network)) / network.glassy();
}

LinearMotion SwitchedSystem::slipping(double sign) const {
  LinearMotion motion;
  motion.force = sign * bound_;
  const Row force_rate = sign * bound_rate_;
  const Row rate = elongation_rate(contact_, motion.force, force_rate);
  Row body = velocity_ * unit(states_);
  if (has_body_)
    body = unit(states_ - 2);
  else if (has_drive_)
    body -= elongation_rate(drive_, motion.force, force_rate);
  motion.contact_velocity = body - rate;
  set_rates(motion, rate, body);
  return motion;
}

// A massless body: k_d d + c_d (v - u) + sum g_j = k0 e + c u + sum q_j, or without dampers the
// derivative of it.
Row SwitchedSystem::stuck_body_velocity() const {
  const Row drawn = velocity_ * unit(states_);
  if (!has_drive_) return drawn;
  if (has_body_) return unit(states_ - 2);
  const double damper = contact_.damper + drive_.damper;
  if (damper > 0) return (elastic(drive_) + drive_.damper * drawn - elastic(contact_)) / damper;
  return (drive_.glassy() * drawn - relaxing(drive_) + relaxing(contact_)) /
         (drive_.glassy() + contact_.glassy());
}

LinearMotion SwitchedSystem::sticking() const {
  LinearMotion motion;
  const Row body = stuck_body_velocity();
  motion.contact_velocity = Row::Zero(states_ + 3);
  motion.force = elastic(contact_) + contact_.damper * body;
  set_rates(motion, body, body);
  return motion;
}

void SwitchedSystem::set_network(Eigen::MatrixXd& rates, const SwitchedNetwork& network,
                                 const Row& rate) const {
  Index row = network.first;
  if (network.spring > 0) rates.row(row++) = network.spring * rate;
  for (const MaxwellBranch& branch : network.branches) {
    rates.row(row) = branch.stiffness * rate - unit(row) / branch.time;
    ++row;
  }
}

void SwitchedSystem::set_rates(LinearMotion& motion, const Row& rate, const Row& body) const {
  motion.rates = Eigen::MatrixXd::Zero(states_, states_ + 3);
  set_network(motion.rates, contact_, rate);
  const Row drawn = velocity_ * unit(states_) - body;
  if (has_drive_) set_network(motion.rates, drive_, drawn);
  if (has_body_)
    motion.rates.row(states_ - 2) =
        (elastic(drive_) + drive_.damper * drawn - motion.force) / mass_;
  motion.rates.row(states_ - 1) = motion.force;
}

VectorXd SwitchedSystem::extended(const VectorXd& y, double t) const {
  VectorXd all(states_ + 3);
  all << y, 1, std::cos(t), std::sin(t);
  return all;
}

double SwitchedSystem::bound(double t) const {
  return bound_(states_) + bound_(states_ + 1) * std::cos(t) + bound_(states_ + 2) * std::sin(t);
}

double SwitchedSystem::rate(const Row& quantity, Motion which, const VectorXd& y, double t) const {
  return quantity.head(states_).dot(motion(which).rates * extended(y, t)) -
         quantity(states_ + 1) * std::sin(t) + quantity(states_ + 2) * std::cos(t);
}

void SwitchedSystem::project(VectorXd& y, const SwitchedNetwork& network, double force) const {
  if (network.damper > 0 || network.size() == 0) return;
  const auto stiffer = [](const MaxwellBranch& a, const MaxwellBranch& b) {
    return a.stiffness < b.stiffness;
  };
  Index carrier = network.first;
  if (network.spring == 0)
    carrier += std::max_element(network.branches.begin(), network.branches.end(), stiffer) -
               network.branches.begin();
  y(carrier) += force - y.segment(network.first, network.size()).sum();
}

void SwitchedSystem::project(VectorXd& y, double force) const {
  project(y, contact_, force);
  if (has_drive_ && !has_body_) project(y, drive_, force);
}

Motion SwitchedSystem::motion_of(const VectorXd& y, double t) const {
  const double force = stick_.force.dot(extended(y, t));
  if (std::abs(force) <= bound(t)) return Motion::stick;
  return force > 0 ? Motion::slip : Motion::backslip;
}

}  // namespace vcrit::simulators
