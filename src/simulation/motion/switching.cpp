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
    rate[0] = direction(state.motion) * model.bound_rate(state.at);
  }
  for (Index j = 0; j < model.units(); ++j)
    rate[units + j] =
        contact.unit_fluidity[j] * rate[0] - contact.unit_rates[j] * state.x[units + j];
  return rate;
}

State switched(const Model& model, const State& before, Motion to) {
  ensure((before.motion == Motion::stick) != (to == Motion::stick), "stick and slip take turns");
  State after{to, before.at, Vector(states(model, to)), direction(before.motion) + direction(to)};
  carry_over(model, before.x, after.x);
  after.x[0] = after.entered * model.bound(before.at);
  if (to == Motion::stick)
    add_force_rate(model, after.entered * model.bound_rate(before.at), after.x);
  return after;
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
      add_force_rate(model, after.entered * model.bound_curvature(after.at) * shifts[j], dx);
    dx[0] = after.entered * model.bound_rate(after.at) * shifts[j];
    for (Index i = 0; i < dx.size(); ++i) dx[i] -= rate_after[i] * shifts[j];
  }
  changes = result;
}

}  // namespace vcrit::simulation
