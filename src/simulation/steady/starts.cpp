// Where a simulation begins: on the steady sliding motion, or at rest with the contact unloaded.
#include <cmath>

#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

using namespace std::complex_literals;

State sliding_start(const Model& model, double velocity) {
  State state{Motion::slip, -std::arg(model.sliding_velocity), Vector::Zero(model.slip_states()),
              0};
  const std::complex<double> turn = std::exp(1i * state.time);
  const Index body = model.body_states(), contact = model.units();
  state.x(0) = model.bound(state.time);
  state.x.tail(contact) = (model.sliding_rates.tail(contact) * turn).real();
  state.x.segment(1, body) = (model.sliding_rates.head(body) * (turn / 1i)).real();
  if (!model.body)
    return contact_velocity(model, velocity, state) > 0 ? state : rest_start(model, velocity);
  state.x(1) -= model.body->fluidity;
  for (Index j = 0; j + 1 < body; ++j) {
    const auto branch = static_cast<std::size_t>(j);
    const double rate = model.body->drive.rates[branch];
    state.x(2 + j) -=
        rate == 0 ? 1 : model.body->drive.weights[branch] * model.body->fluidity / rate;
  }
  // Under a drive that creeps faster than it moves, the body starts ahead of it.
  const double slip = contact_velocity(model, velocity, state);
  if (slip <= 0) state.x(1) += std::abs(model.sliding_velocity) - slip;
  return state;
}

State rest_start(const Model& model, double velocity) {
  const double top = model.body ? 0 : velocity;
  State state{Motion::stick, 0, Vector::Zero(model.stick_states()), 0};
  state.x(0) = model.contact.damper * top;
  if (model.body) state.x(1) = -velocity;
  state.x.segment(model.level_states(), model.branches()) = model.contact.branch_stiffness * top;
  state.x.tail(model.units()) = model.contact.unit_fluidity * state.x(0);
  if (state.x(0) < model.bound(0)) return state;
  State slip{Motion::slip, 0, Vector::Zero(model.slip_states()), 0};
  slip.x.head(model.level_states()) = state.x.head(model.level_states());
  slip.x(0) = model.bound(0);
  slip.x.tail(model.units()) = model.contact.unit_fluidity * model.bound(0);
  return slip;
}

}  // namespace vcrit::simulation
