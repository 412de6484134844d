#include "simulation/switching.hpp"

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

// How the contact's part of x goes over, less what depends on time alone.
const Matrix& contact_map(const Model& model, const State& before) {
  return before.motion == Motion::stick ? model.contact.to_units : model.contact.to_branches;
}

int slip_side(const State& before, const State& after) {
  return direction(before.motion) + direction(after.motion);
}

// Rate of the contact velocity in slip.
double acceleration(const Model& model, const State& slip, const Vector& rate) {
  const double body = model.body ? rate(1) : 0;
  return body - model.contact.fluidity * rate(0) -
         direction(slip.motion) * model.contact.glassy * model.bound_curvature(slip.time) -
         rate.tail(contact_states(model, slip)).sum();
}

// Changes of the event's time: it is where w = 0 in slip, where side F = b in stick.
Eigen::RowVectorXd time_changes(const Model& model, const State& before, const State& after,
                                const Vector& rate, const Matrix& dx) {
  if (before.motion == Motion::stick) {
    const int side = slip_side(before, after);
    return -side * dx.row(0) / (side * rate(0) - model.bound_rate(before.time));
  }
  Eigen::RowVectorXd velocity = -dx.bottomRows(contact_states(model, before)).colwise().sum();
  if (model.body) velocity += dx.row(1);
  return -velocity / acceleration(model, before, rate);
}

}  // namespace

Vector rate_of(const Model& model, const State& state) {
  const Vector y = model.rates(state.x);
  const Index body = model.body_states(), contact = contact_states(model, state);
  const double body_acceleration = model.body ? y(0) : 0;
  const bool stuck = state.motion == Motion::stick;
  const ContactModes& modes = model.contact;
  const Vector decay = Vector::Map((stuck ? modes.branch_rates : modes.unit_rates).data(), contact);
  Vector rate(state.x.size());
  rate(0) = stuck ? y.tail(contact).sum() + modes.damper * body_acceleration
                  : direction(state.motion) * model.bound_rate(state.time);
  rate.segment(1, body) = y.head(body);
  rate.tail(contact) = (stuck ? Vector(modes.branch_stiffness * body_acceleration)
                              : Vector(modes.unit_fluidity * rate(0))) -
                       decay.cwiseProduct(state.x.tail(contact));
  return rate;
}

State switched(const Model& model, const State& before, Motion to) {
  ensure((before.motion == Motion::stick) != (to == Motion::stick), "stick and slip take turns");
  State after{to, before.time, Vector(states(model, to)), 0};
  after.entered = slip_side(before, after);
  const Index levels = model.level_states();
  after.x.head(levels) = before.x.head(levels);
  after.x(0) = after.entered * model.bound(before.time);
  Vector contact = contact_map(model, before) * before.x.tail(contact_states(model, before));
  if (to == Motion::stick)
    contact += model.contact.branch_stiffness *
               (model.contact.glassy * after.entered * model.bound_rate(before.time));
  after.x.tail(contact.size()) = contact;
  return after;
}

Matrix switched_changes(const Model& model, const State& before, const State& after,
                        const Matrix& dx) {
  const Vector rate_before = rate_of(model, before), rate_after = rate_of(model, after);
  const Eigen::RowVectorXd dt = time_changes(model, before, after, rate_before, dx);
  const Matrix moved = dx + rate_before * dt;
  const Index levels = model.level_states();
  Matrix result(after.x.size(), dx.cols());
  result.topRows(levels) = moved.topRows(levels);
  result.bottomRows(after.x.size() - levels) =
      contact_map(model, before) * moved.bottomRows(before.x.size() - levels);
  if (after.motion == Motion::stick)
    result.bottomRows(after.x.size() - levels) +=
        model.contact.branch_stiffness *
        (model.contact.glassy * after.entered * model.bound_curvature(after.time)) * dt;
  result.row(0) = after.entered * model.bound_rate(after.time) * dt;
  return result - rate_after * dt;
}

}  // namespace vcrit::simulation
