#include "simulation/steady/closing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

// residual = sum of the weights times integrals.
class ByIntegrals {
 public:
  ByIntegrals(const Passage& period, Closing& closing) : period_(period), closing_(closing) {}

  void set(Index row, Index first, double weight, Index second = 0, double other = 0) {
    const Matrix& changes = period_.changes.integrals;
    closing_.residual[row] = weight * period_.integrals[first] + other * period_.integrals[second];
    for (Index j = 0; j < changes.columns(); ++j)
      closing_.derivative(row, j) = -weight * changes(first, j) - other * changes(second, j);
  }

 private:
  const Passage& period_;
  Closing& closing_;
};

// A branch of the drive changes by k_j X - a_j G_j in one period, X and G_j the integrals of u and
// g_j. Of slow branches the first part is nearly all and belongs to the whole drive; taken off in
// multiples of the slowest branch's change, the rest keeps its relative accuracy. A unit of the
// contact changes by psi_j times the change of F, which is none, less beta_j times its integral.
void close_slow_states(const Model& model, const Passage& period, Closing& closing) {
  ByIntegrals rows(period, closing);
  for (Index j = 0; j < model.slow_branches; ++j) {
    const PoleSum& drive = model.body->drive;
    if (j == 0) {
      rows.set(1, 1, drive.weights[0], 2, -drive.rates[0]);
      continue;
    }
    const double share = drive.weights[j] / drive.weights[0];
    rows.set(1 + j, 2, share * drive.rates[0], 2 + j, -drive.rates[j]);
    closing.identity(1 + j, 1) = -share;
  }
  for (Index j = 0; j < model.slow_units; ++j)
    rows.set(model.body_states() + j, model.integrated_levels() + j, -model.contact.unit_rates[j]);
}

// The largest change of the body's velocity that friction and drive cause in a period.
double shove(const Model& model, const State& start) {
  double force = model.force_size();
  if (const auto& masses = model.body->masses) {
    for (Index j = 0; j < masses->states(); ++j)
      force += masses->mass * std::abs(masses->rates(0, j) * start.x[1 + j]);
    return two_pi * force / masses->mass;
  }
  for (Index j = 0; j + 1 < model.body_states(); ++j) force += std::abs(start.x[2 + j]);
  return two_pi * force / model.body->mass;
}

// contact_speed: with which a light body moves while it sticks.
Vector size_beside(const Model& model, double contact_speed, const State& start) {
  const Index n = start.x.size() - 1, body = model.body_states();
  const double force = model.force_size();
  Vector size(n);
  for (Index i = 0; i < n; ++i)
    size[i] = std::abs(start.x[1 + i]) + std::abs(model.sliding_rates[i]);
  if (body > 0) size[0] += std::min(contact_speed, shove(model, start));
  // The force of a branch follows the oscillation of the body, and creeps with the whole drive.
  for (Index j = 0; j + 1 < body; ++j) {
    if (model.body->masses) {  // velocities like u
      size[1 + j] += size[0];
      continue;
    }
    const double rate = model.body->drive.rates[j], weight = model.body->drive.weights[j];
    const double creep = force * model.body->fluidity;
    size[1 + j] += rate == 0 ? force : weight * (size[0] / (1 + rate) + creep / rate);
  }
  for (Index j = 0; j < model.units(); ++j)
    size[body + j] += force * model.contact.unit_fluidity[j] / (1 + model.contact.unit_rates[j]);
  return size;
}

// The residuals of slow states are as small as what relaxes of them in a period.
Vector rounding_of(const Model& model, Vector unit) {
  const auto relax = [&](double& size, double rate) { size *= std::min(1.0, two_pi * rate); };
  double whole = 0;
  for (Index j = 0; j < model.slow_branches; ++j) {
    const PoleSum& drive = model.body->drive;
    relax(unit[1 + j], drive.rates[j]);
    if (j == 0) whole = unit[1] / drive.weights[0];
    unit[1 + j] += drive.weights[j] * (j == 0 ? two_pi * unit[0] : whole);
  }
  for (Index j = 0; j < model.slow_units; ++j)
    relax(unit[model.body_states() + j], model.contact.unit_rates[j]);
  for (double& size : unit) size *= 8 * epsilon * model.amplification;
  return unit;
}

}  // namespace

Closing closing(const Model& model, const State& start, const Passage& period) {
  const Index n = start.x.size() - 1;
  const Matrix& changes = period.changes.state;
  Closing result{Vector(n), Matrix(n, changes.columns()), identity(n)};
  for (Index i = 0; i < n; ++i) {
    result.residual[i] = period.end.x[1 + i] - start.x[1 + i];
    for (Index j = 0; j < changes.columns(); ++j)
      result.derivative(i, j) = (i == j ? 1 : 0) - changes(1 + i, j);
  }
  close_slow_states(model, period, result);
  return result;
}

double close_heavy_body(const Model& model, const Passage& period, Closing& closing) {
  if (!model.body || model.body->fluidity == 0 || model.body->masses) return 0;
  const auto& [mass, drive, fluidity, none] = *model.body;
  if (two_pi > mass * fluidity) return 0;
  // The impulse on the body is the sum of weights times integrals, and of fast branches, whose
  // integrals are not kept, of what these change by.
  const Matrix& changes = period.changes.integrals;
  Vector weights(model.integrated_levels());
  weights[0] = 1;
  weights[1] = drive.direct;
  for (Index j = 0; j < drive.rates.size(); ++j) {
    if (j < model.slow_branches)
      weights[2 + j] = 1;
    else
      weights[1] += drive.weights[j] / drive.rates[j];
  }
  Vector row(changes.columns());
  double impulse = 0, size = 0;
  for (Index i = 0; i < weights.size(); ++i) {
    const double part = weights[i] * period.integrals[i];
    impulse += part;
    size += std::abs(part);
    for (Index c = 0; c < row.size(); ++c) row[c] += weights[i] * changes(i, c);
  }
  for (Index j = model.slow_branches; j < drive.rates.size(); ++j) {
    impulse -= closing.residual[1 + j] / drive.rates[j];
    for (Index c = 0; c < row.size(); ++c) row[c] += closing.derivative(1 + j, c) / drive.rates[j];
  }
  closing.residual[0] = -impulse / mass;
  for (Index c = 0; c < row.size(); ++c) closing.derivative(0, c) = row[c] / mass;
  return 8 * epsilon * size / mass;
}

LinearSolver counted_solver(const Model& model, Matrix derivative, ConstView sizes) {
  model.effort.spend(Effort::of_products(LinearSolver::work(derivative.rows())));
  return {std::move(derivative), sizes};
}

Vector state_size(const Model& model, double velocity, const State& start) {
  return size_beside(model, velocity + std::abs(model.sliding_velocity), start);
}

Vector rounding(const Model& model, double velocity, const State& start) {
  return rounding_of(model, state_size(model, velocity, start));
}

// Slow branches tell by their integrals how far a period is from closed.
void check_settles(const Model& model) {
  if (model.slow_branches == 0) check_cycles_settle(model);
}

void check_cycles_settle(const Model& model) {
  if (!model.body || model.body->fluidity == 0 || model.body->masses) return;
  const PoleSum& drive = model.body->drive;
  double hold = drive.direct;
  for (Index j = 0; j < drive.rates.size(); ++j) hold += drive.weights[j] / drive.rates[j];
  if (two_pi * hold <= 8 * epsilon * model.body->mass)
    throw ModelError(
        "the body is so heavy that in a period its drive, which creeps, changes its velocity by "
        "less than a rounding error: where that settles is lost in rounding");
}

void lost_at_closings() {
  throw ModelError(
      "a damper of the contact is so weak, or a Maxwell branch so fast, that the speed of the "
      "contact point where the contact closes is lost in rounding",
      "leave out what relaxes within a part in 1e12 of a period");
}

double parts_of_bound(const Opening& opening) {
  double force = 1 + opening.amplitude;
  for (const Opening::Touch& touch : opening.touches) force += sum_of_sizes(touch.decaying);
  return force;
}

// The path's stiffness is 1. What rounding the jump does to the velocity lasts for as long as the
// damper relaxes, so friction hardly notices it until sums of stiffness and damper lose the damper.
void check_closings(const Model& model) {
  if (!model.opening || !model.opening->jumps || model.contact.damper == 0) return;
  if (!(model.contact.damper > 4 * epsilon)) lost_at_closings();
}

// A body that passes through rest is as uncertain as it is half a swing later.
Vector slip_rounding(const Model& model, const State& start) {
  State state = start;
  if (model.body)
    state.x[1] =
        std::abs(state.x[1]) + swing(model, ConstView(state.x).subspan(1, model.body_states()));
  return rounding_of(model, size_beside(model, 0, state));
}

// A quarter of a free swing later; beside a damper at most what the force moves that by, however
// light the body.
double swing(const Model& model, ConstView body) {
  if (model.body->masses) return sum_of_sizes(body.subspan(1));
  const PoleSum& drive = model.body->drive;
  double sum = 0;
  for (Index j = 0; j + 1 < body.size(); ++j)
    sum += std::abs(body[1 + j]) /
           std::max(std::sqrt(model.body->mass * drive.weights[j]), drive.direct);
  return sum;
}

}  // namespace vcrit::simulation
