#include "simulation/motion/switching.hpp"

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

// How x goes over, less what depends on time alone: slip has the levels and units, stick also the
// branches between them.
Matrix carried_over(const Model& model, const Matrix& before, Motion to) {
  const Index levels = model.level_states(), units = model.units();
  Matrix after(states(model, to), before.cols());
  after.topRows(levels) = before.topRows(levels);
  after.bottomRows(units) = before.bottomRows(units);
  if (to == Motion::stick)
    after.middleRows(levels, model.branches()) =
        model.contact.to_branches * before.bottomRows(units);
  return after;
}

// The part of a stick's branches that depends on the time of its beginning, by F'.
Vector branches_by_force(const Model& model) {
  return model.contact.branch_stiffness * model.contact.glassy;
}

int slip_side(const State& before, const State& after) {
  return direction(before.motion) + direction(after.motion);
}

// Rate of the contact velocity in slip.
double acceleration(const Model& model, const State& slip, const Vector& rate) {
  const double body = model.body ? rate(1) : 0;
  return body - model.contact.fluidity * rate(0) -
         direction(slip.motion) * model.contact.glassy * model.bound_curvature(slip.time) -
         rate.tail(model.units()).sum();
}

// Changes of the event's time: it is where w = 0 in slip, where side F = b in stick.
Eigen::RowVectorXd time_changes(const Model& model, const State& before, const State& after,
                                const Vector& rate, const Matrix& dx) {
  if (before.motion == Motion::stick) {
    const int side = slip_side(before, after);
    return -side * dx.row(0) / (side * rate(0) - model.bound_rate(before.time));
  }
  Eigen::RowVectorXd velocity = -dx.bottomRows(model.units()).colwise().sum();
  if (model.body) velocity += dx.row(1);
  return -velocity / acceleration(model, before, rate);
}

}  // namespace

Vector rate_of(const Model& model, const State& state) {
  const bool stuck = state.motion == Motion::stick;
  const Vector y = model.rates(state.x, stuck);
  const Index levels = model.level_states(), branches = model.branches(), units = model.units();
  const ContactModes& modes = model.contact;
  const double body_acceleration = model.body ? y(0) : 0;
  Vector rate(state.x.size());
  rate(0) = stuck ? y.tail(branches).sum() + modes.damper * body_acceleration
                  : direction(state.motion) * model.bound_rate(state.time);
  rate.segment(1, levels - 1) = y.head(levels - 1);
  const auto decay = [&](const std::vector<double>& rates, Index first) {
    const auto n = static_cast<Index>(rates.size());
    return Vector(Vector::Map(rates.data(), n).cwiseProduct(state.x.segment(first, n)));
  };
  if (stuck)
    rate.segment(levels, branches) =
        modes.branch_stiffness * body_acceleration - decay(modes.branch_rates, levels);
  rate.tail(units) =
      modes.unit_fluidity * rate(0) - decay(modes.unit_rates, state.x.size() - units);
  return rate;
}

State switched(const Model& model, const State& before, Motion to) {
  ensure((before.motion == Motion::stick) != (to == Motion::stick), "stick and slip take turns");
  State after{to, before.time, carried_over(model, before.x, to), 0};
  after.entered = slip_side(before, after);
  after.x(0) = after.entered * model.bound(before.time);
  if (to == Motion::stick)
    after.x.segment(model.level_states(), model.branches()) +=
        branches_by_force(model) * (after.entered * model.bound_rate(before.time));
  return after;
}

Matrix switched_changes(const Model& model, const State& before, const State& after,
                        const Matrix& dx) {
  const Vector rate_before = rate_of(model, before), rate_after = rate_of(model, after);
  const Eigen::RowVectorXd dt = time_changes(model, before, after, rate_before, dx);
  Matrix result = carried_over(model, dx + rate_before * dt, after.motion);
  if (after.motion == Motion::stick)
    result.middleRows(model.level_states(), model.branches()) +=
        branches_by_force(model) * (after.entered * model.bound_curvature(after.time)) * dt;
  result.row(0) = after.entered * model.bound_rate(after.time) * dt;
  return result - rate_after * dt;
}

}  // namespace vcrit::simulation
