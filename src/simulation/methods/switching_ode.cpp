#include "simulation/methods/switching_ode.hpp"

#include <algorithm>

namespace vcrit::simulation::methods {

// With a direct damper F = c (u - w) + sum f_j = s b; without, its derivative tells w.
double SwitchingOde::slip_velocity(const double* y, double top, double bound,
                                   double bound_rate) const {
  const Chain& contact = equations_.contact;
  const double* forces = equations_.contact_forces(y);
  if (damped()) return top - (sign() * bound - contact.sum(forces)) / contact.damper;
  return top - (sign() * bound_rate + contact.fading(forces)) / contact.glassy;
}

void SwitchingOde::rates(const double* y, double velocity, double bound, double bound_rate,
                         double* dydt) const {
  const double top = equations_.top_velocity(y, velocity);
  double& deficit = dydt[equations_.size()];
  if (motion == Motion::stick) {
    const double force =
        equations_.contact.damper * top + equations_.contact.sum(equations_.contact_forces(y));
    equations_.rates(y, velocity, 0, force, dydt);
    deficit = bound - force;
    return;
  }
  const double w = slip_velocity(y, top, bound, bound_rate);
  equations_.rates(y, velocity, w, sign() * bound, dydt);
  deficit = motion == Motion::slip ? 0 : 2 * bound;
}

void SwitchingOde::rates(double t, const double* y, double* dydt) {
  rates(y, equations_.velocity, equations_.bound(t), slope_of_bound(t), dydt);
}

// The rates are linear in state, drive velocity and bound together.
void SwitchingOde::jacobian(double t, const double*, double* by_y, double* by_t) {
  const std::size_t n = equations_.size() + 1;
  scratch_.assign(2 * n, 0.0);
  double* const unit = scratch_.data();
  double* const column = unit + n;
  for (std::size_t j = 0; j < n; ++j) {
    unit[j] = 1;
    rates(unit, 0, 0, 0, column);
    unit[j] = 0;
    for (std::size_t i = 0; i < n; ++i) by_y[i * n + j] = column[i];
  }
  rates(unit, 0, equations_.bound_rate(t), equations_.bound_curvature(t), by_t);
}

double SwitchingOde::event(double t, const double* y) const {
  if (motion == Motion::stick) return equations_.bound(t) - std::abs(equations_.force(y, 0));
  return sign() * slip_velocity(y, equations_.top_velocity(y, equations_.velocity),
                                equations_.bound(t), slope_of_bound(t));
}

double SwitchingOde::event_rate(double t, const double* y, const double* dydt) const {
  const double acceleration = equations_.top_velocity(dydt, 0);
  if (motion == Motion::stick) {
    const double force_rate = equations_.contact.damper * acceleration +
                              equations_.contact.sum(equations_.contact_forces(dydt));
    return equations_.bound_rate(t) - (equations_.force(y, 0) < 0 ? -force_rate : force_rate);
  }
  return sign() *
         slip_velocity(dydt, acceleration, equations_.bound_rate(t), equations_.bound_curvature(t));
}

double SwitchingOde::rate_of_event(double t, const std::vector<double>& y) {
  scratch_.resize(y.size());
  rates(t, y.data(), scratch_.data());
  return event_rate(t, y.data(), scratch_.data());
}

// With a direct damper the force that stick would take decides between the motions. Without one, a
// slip with w < 0 is a stick whose |F| leaves b with the slope K_g w.
Rise SwitchingOde::adopt(double t, std::vector<double>& y) {
  tie(t, y);
  const double value = event(t, y.data());
  if (value > 0) return {};
  if (!damped()) {
    if (motion == Motion::stick) return begin_slip(t, y);
    motion = Motion::stick;
    return {1, -equations_.contact.glassy * value};
  }
  const double force = equations_.force(y.data(), 0);
  motion = std::abs(force) < equations_.bound(t) ? Motion::stick
           : force > 0                           ? Motion::slip
                                                 : Motion::backslip;
  return {};
}

Rise SwitchingOde::change(double t, std::vector<double>& y) {
  return motion == Motion::stick ? begin_slip(t, y) : begin_stick(t, y);
}

void SwitchingOde::tie(double t, std::vector<double>& y) const {
  if (!tied()) return;
  y[equations_.contact_begin() + equations_.contact.main_branch()] +=
      sign() * equations_.bound(t) - equations_.force(y.data(), 0);
}

// b - |F| begins with slope -c |w|' or, without a damper, with curvature -K_g |w|'.
Rise SwitchingOde::begin_stick(double t, std::vector<double>& y) {
  const Motion before = motion;
  const double slowing = rate_of_event(t, y);
  tie(t, y);
  motion = Motion::stick;
  const Rise rise =
      damped() ? Rise{1, rate_of_event(t, y)} : Rise{2, -equations_.contact.glassy * slowing / 2};
  if (rise.value > 0) return rise;
  motion = before;  // w only touches 0
  return {1, std::abs(slowing)};
}

// w begins with slope |F|'/c or jumps to |F|'/K_g beyond what b allows.
Rise SwitchingOde::begin_slip(double t, std::vector<double>& y) {
  motion = equations_.force(y.data(), 0) > 0 ? Motion::slip : Motion::backslip;
  tie(t, y);
  const Rise rise = damped() ? Rise{1, rate_of_event(t, y)} : Rise{0, event(t, y.data())};
  if (rise.value > 0) return rise;
  motion = Motion::stick;  // |F| only touches b
  return {1, std::abs(rate_of_event(t, y))};
}

}  // namespace vcrit::simulation::methods
