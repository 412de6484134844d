// Where a simulation begins: on the steady sliding motion, or at rest with the contact unloaded.
#include <algorithm>
#include <cmath>

#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

namespace {

// Of all that moves with the body, where the drive has masses.
void add_body_velocity(const Model& model, double velocity, View x) {
  if (const auto& masses = model.body->masses)
    add(masses->rest, velocity, x.subspan(1, masses->states()));
  else
    x[1] += velocity;
}

}  // namespace

State separated_start(const Model& model, double velocity, bool at_rest) {
  const Opening::Middle middle = model.opening->middle();
  State state{Motion::separated, middle.time, Vector(model.slip_states()), 0, middle.next};
  if (model.body && at_rest) add_body_velocity(model, -velocity, state.x);
  if (!at_rest) model.add_steady(1, state.x);
  state.x[0] = 0;
  return state;
}

State sliding_start(const Model& model, double velocity) {
  if (model.opening) return separated_start(model, velocity, false);
  State state{Motion::slip, -std::arg(model.sliding_velocity), Vector(model.slip_states()), 0};
  const Index body = model.body_states(), levels = model.level_states();
  state.x[0] = model.slip_force(1, state.at);
  for (Index j = 0; j < model.units(); ++j)
    state.x[levels + j] = (model.sliding_rates[body + j] * state.at.turn).real();
  if (!model.body)
    return contact_velocity(model, velocity, state) > 0 ? state : rest_start(model, velocity);
  using namespace std::complex_literals;
  for (Index j = 0; j < body; ++j)
    state.x[1 + j] = (model.sliding_rates[j] * (state.at.turn / 1i)).real();
  // Under a drive that creeps faster than it moves, the body starts ahead of it.
  const double slip = contact_velocity(model, velocity, state);
  if (slip <= 0) state.x[1] += std::abs(model.sliding_velocity) - slip;
  return state;
}

State rest_start(const Model& model, double velocity) {
  if (model.opening) return separated_start(model, velocity, true);
  const double drive = velocity + model.creep, top = model.body ? 0 : drive;
  const Index levels = model.level_states(), branches = model.branches();
  State stick{Motion::stick, 0, Vector(model.stick_states()), 0};
  const double force = model.contact.damper * top;
  stick.x[0] = force;
  if (model.body) add_body_velocity(model, -drive, stick.x);
  model.add_steady(-model.load, stick.x);
  for (Index i = 0; i < branches; ++i)
    stick.x[levels + i] = model.contact.branch_stiffness[i] * top;
  for (Index j = 0; j < model.units(); ++j)
    stick.x[levels + branches + j] = model.contact.unit_fluidity[j] * force;
  if (force < model.bound(0)) return stick;
  State slip{Motion::slip, 0, Vector(model.slip_states()), 0};
  std::copy(stick.x.begin(), stick.x.begin() + static_cast<std::ptrdiff_t>(levels), slip.x.begin());
  slip.x[0] = model.slip_force(1, 0);
  for (Index j = 0; j < model.units(); ++j)
    slip.x[levels + j] = model.contact.unit_fluidity[j] * model.bound(0);
  return slip;
}

}  // namespace vcrit::simulation
