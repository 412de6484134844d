#include "simulation/motion/switching.hpp"

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

// How x goes over, less what depends on time alone: slip has the levels and units, stick also the
// branches between them.
void carry_over(const Model& model, ConstView before, View after) {
  const Index levels = model.level_states(), units = model.units();
  for (Index i = 0; i < levels; ++i) after[i] = before[i];
  const ConstView creep = before.last(units);
  std::copy(creep.begin(), creep.end(), after.last(units).begin());
  if (after.size() > levels + units)
    add_product(model.contact.to_branches, creep, after.subspan(levels, model.branches()));
}

// Adds what a stick's branches owe to the force's rate at its beginning.
void add_force_rate(const Model& model, double rate, View stick) {
  for (Index i = 0; i < model.branches(); ++i)
    stick[model.level_states() + i] +=
        model.contact.branch_stiffness[i] * model.contact.glassy * rate;
}

}  // namespace

Vector rate_of(const Model& model, const State& state) {
  const bool stuck = state.motion == Motion::stick;
  const ContactModes& contact = model.contact;
  const Index levels = model.level_states(), units = state.x.size() - model.units();
  Vector y((stuck ? model.stick : model.slip).modes.to_modes.columns());
  model.rates(state.x, stuck, y);
  const double body_acceleration = model.body ? y[0] : 0;
  Vector rate(state.x.size());
  for (Index i = 1; i < levels; ++i) rate[i] = y[i - 1];
  if (stuck) {
    rate[0] = contact.damper * body_acceleration;
    for (Index i = 0; i < model.branches(); ++i) {
      const double branch = state.x[levels + i];
      rate[0] += branch;
      rate[levels + i] =
          contact.branch_stiffness[i] * body_acceleration - contact.branch_rates[i] * branch;
    }
  } else {
    rate[0] = direction(state.motion) * model.bound_rate(state.at, state.touch);
  }
  for (Index j = 0; j < model.units(); ++j)
    rate[units + j] =
        contact.unit_fluidity[j] * rate[0] - contact.unit_rates[j] * state.x[units + j];
  return rate;
}

State switched(const Model& model, const State& before, Motion to) {
  ensure((before.motion == Motion::stick) != (to == Motion::stick), "stick and slip take turns");
  State after{to, before.at, Vector(states(model, to)), direction(before.motion) + direction(to),
              before.touch};
  carry_over(model, before.x, after.x);
  after.x[0] = model.slip_force(after.entered, before.at, before.touch);
  if (to == Motion::stick)
    add_force_rate(model, after.entered * model.bound_rate(before.at, before.touch), after.x);
  return after;
}

State after_opening(const Model& model, const State& before) {
  State after{Motion::separated, before.at, Vector(model.slip_states()), 0,
              (before.touch + 1) % model.opening->touches.size()};
  carry_over(model, before.x, after.x);
  after.x[0] = 0;
  return after;
}

namespace {

// How fast the surface would leave the contact point where the contact closes, with no force.
double free_velocity(const Model& model, ConstView x) {
  double velocity = model.body ? x[1] : 0;
  for (const double unit : x.last(model.units())) velocity -= unit;
  return velocity;
}

// A force that jumps deforms each unit the faster.
void add_jump(const Model& model, double force, View x) {
  x[0] += force;
  add(model.contact.unit_fluidity, force, x.last(model.units()));
}

}  // namespace

State after_closing(const Model& model, double velocity, const State& before) {
  const ContactModes& contact = model.contact;
  State after{Motion::stick, before.at, before.x, 0, before.touch};
  const bool jumps = model.opening->jumps;
  const double pull = velocity + free_velocity(model, before.x);
  const double bound = jumps ? model.bound(after.at, after.touch) : 0;
  const auto stick = [&](double force, double force_rate) {
    after.x = Vector(model.stick_states());
    Vector x = before.x;
    add_jump(model, force, x);
    carry_over(model, x, after.x);
    if (contact.damper == 0) add_force_rate(model, force_rate, after.x);
    after.entered = jumps ? 0 : both_sides;
  };
  const auto slip = [&](int side) {
    after.motion = side > 0 ? Motion::slip : Motion::backslip;
    if (contact.damper > 0) add_jump(model, side * bound, after.x);
  };
  if (contact.damper > 0) {
    const double force = contact.damper * pull;
    std::abs(force) < bound ? stick(force, 0) : slip(pull > 0 ? 1 : -1);
  } else {
    const double rate = pull / contact.glassy;
    jumps || std::abs(rate) < model.bound_rate(after.at, after.touch) ? stick(0, rate)
                                                                      : slip(pull > 0 ? 1 : -1);
  }
  return after;
}

void carry_over_opening(const Model& model, Matrix& changes) {
  Matrix result(model.slip_states(), changes.columns());
  for (Index j = 0; j < changes.columns(); ++j) {
    carry_over(model, changes.column(j), result.column(j));
    result(0, j) = 0;
  }
  changes = result;
}

void carry_over_closing(const Model& model, const State& after, Matrix& changes) {
  if (after.motion != Motion::stick) return;
  Matrix result(model.stick_states(), changes.columns());
  for (Index j = 0; j < changes.columns(); ++j) {
    const View before = changes.column(j);
    const double pull = free_velocity(model, before);
    if (model.contact.damper > 0) add_jump(model, model.contact.damper * pull, before);
    carry_over(model, before, result.column(j));
    if (model.contact.damper == 0)
      add_force_rate(model, pull / model.contact.glassy, result.column(j));
  }
  changes = result;
}

// The event's function is F or -w towards the side of the slip.
Vector event_shifts(const Model& model, const State& before, Motion to, double slope,
                    const Matrix& changes) {
  Vector shifts;
  for (Index j = 0; j < changes.columns(); ++j) {
    const ConstView dx = changes.column(j);
    double change = dx[0];
    if (to == Motion::stick) {
      change = model.body ? -dx[1] : 0;
      for (const double unit : dx.last(model.units())) change += unit;
    }
    shifts.push_back(-(direction(before.motion) + direction(to)) * change / slope);
  }
  return shifts;
}

void carry_across(const Model& model, const State& before, const State& after, const Vector& shifts,
                  Matrix& changes) {
  const Vector rate_before = rate_of(model, before), rate_after = rate_of(model, after);
  Matrix result(after.x.size(), changes.columns());
  for (Index j = 0; j < changes.columns(); ++j) {
    const View moved = changes.column(j), dx = result.column(j);
    for (Index i = 0; i < moved.size(); ++i) moved[i] += rate_before[i] * shifts[j];
    carry_over(model, moved, dx);
    if (after.motion == Motion::stick)
      add_force_rate(model,
                     after.entered * model.bound_curvature(after.at, after.touch) * shifts[j], dx);
    dx[0] = after.entered * model.bound_rate(after.at, after.touch) * shifts[j];
    for (Index i = 0; i < dx.size(); ++i) dx[i] -= rate_after[i] * shifts[j];
  }
  changes = result;
}

}  // namespace vcrit::simulation
