// Implicit Euler with the return map for friction: a time-stepping witness that shares nothing with
// the event-driven method but the physics. First order in the step.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "simulation/system/system.hpp"

namespace vcrit::reference {

/// A network in relaxation form, stepped by its end-to-end velocity.
class SteppedNetwork {
 public:
  explicit SteppedNetwork(const Relaxation& form)
      : form_(form), branches_(form.branches.size(), 0.0) {}

  /// Force after a step h at velocity e' is offset(h) + slope(h) e'.
  double slope(double h) const {
    double sum = form_.damper + form_.equilibrium * h;
    for (const MaxwellBranch& b : form_.branches) sum += b.stiffness * h / (1 + h / b.time);
    return sum;
  }
  double offset(double h) const {
    double sum = spring_;
    for (std::size_t j = 0; j < branches_.size(); ++j)
      sum += branches_[j] / (1 + h / form_.branches[j].time);
    return sum;
  }
  void step(double h, double velocity) {
    spring_ += form_.equilibrium * h * velocity;
    for (std::size_t j = 0; j < branches_.size(); ++j) {
      const MaxwellBranch& b = form_.branches[j];
      branches_[j] = (branches_[j] + b.stiffness * h * velocity) / (1 + h / b.time);
    }
  }

 private:
  Relaxation form_;
  double spring_ = 0;
  std::vector<double> branches_;
};

/// <F>/(mu0 <F_n>) over the last of `cycles` periods from rest, omega = 1.
inline double stepped_friction_ratio(const simulation::System& s, double velocity, int cycles,
                                     int steps) {
  const double h = 2 * std::numbers::pi / steps, mass = s.mass.value_or(0);
  SteppedNetwork contact(s.contact), drive(s.drive.value_or(Relaxation{}));
  double body = 0, impulse = 0;
  for (int i = 1; i <= cycles * steps; ++i) {
    const double bound = s.friction * (s.mean_normal_force +
                                       (s.normal_force_amplitude * std::polar(1.0, i * h)).real());
    const double kc = contact.slope(h), fc = contact.offset(h);
    const double kd = drive.slope(h), fd = drive.offset(h);
    // Stick first: the body's velocity, then the force it takes; beyond the bound it slips.
    const auto body_velocity = [&](double force, double stiffness) {
      if (!s.drive) return velocity;
      return (mass / h * body + fd + kd * velocity - force) / (mass / h + kd + stiffness);
    };
    double v = body_velocity(fc, kc), force = fc + kc * v, slip = 0;
    if (std::abs(force) > bound) {
      force = std::copysign(bound, force);
      v = body_velocity(force, 0);
      slip = v - (force - fc) / kc;
    }
    contact.step(h, v - slip);
    drive.step(h, velocity - v);
    body = v;
    if (i > (cycles - 1) * steps) impulse += force;
  }
  return impulse / steps / (s.friction * s.mean_normal_force);
}

}  // namespace vcrit::reference
