#include "simulation/steady/closing.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace vcrit::simulation {

namespace {

constexpr double period = 2 * std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A branch of the drive that relaxes over many periods changes by k_j X - a_j G_j in one, X and
// G_j the integrals of u and g_j. The first part is nearly all of it and belongs to the whole
// drive; taken off in multiples of the slowest branch's change, the rest keeps its relative
// accuracy.
void close_slow_branches(const Model& model, const Passage& passage, Closing& closing) {
  const Matrix& changes = passage.changes.integrals;
  const Index n = closing.residual.size();
  for (Index j = 1; j + 1 < model.body_states(); ++j) {
    const PoleSum& drive = model.body->drive;
    const double slow = drive.rates[j];
    if (slow >= 1) return;
    const double share = drive.weights[j] / drive.weights[0], other = share * drive.rates[0];
    closing.identity(1 + j, 1) = -share;
    closing.residual[1 + j] = other * passage.integrals[2] - slow * passage.integrals[2 + j];
    for (Index i = 0; i < changes.columns(); ++i) {
      const double change = slow * changes(2 + j, i) - other * changes(2, i);
      if (i < n)
        closing.derivative(1 + j, i) = change;
      else
        closing.residual[1 + j] -= change;
    }
  }
}

}  // namespace

Closing closing(const Model& model, const State& start, const Passage& passage) {
  const Index n = start.x.size() - 1;
  const Matrix& changes = passage.changes.state;
  Closing result{Vector(n), identity(n), identity(n)};
  for (Index i = 0; i < n; ++i) {
    result.residual[i] = passage.end.x[1 + i] - start.x[1 + i];
    for (Index j = 0; j < changes.columns(); ++j) {
      if (j < n)
        result.derivative(i, j) -= changes(1 + i, j);
      else
        result.residual[i] += changes(1 + i, j);
    }
  }
  close_slow_branches(model, passage, result);
  return result;
}

Vector rounding(const Model& model, double velocity, const State& start) {
  const Index n = start.x.size() - 1, body = model.body_states();
  Vector size(n);
  for (Index i = 0; i < n; ++i)
    size[i] = std::abs(start.x[1 + i]) + std::abs(model.sliding_rates[i]);
  if (body > 0) size[0] += velocity + std::abs(model.sliding_velocity);
  for (Index j = 0; j + 1 < body; ++j) {
    const double rate = model.body->drive.rates[j];
    size[1 + j] = (1 + size[1 + j]) * (j > 0 ? std::min(1.0, period * rate) : 1.0);
  }
  for (Index j = 0; j < model.units(); ++j)
    size[body + j] += model.contact.unit_fluidity[j] / (1 + model.contact.unit_rates[j]);
  for (double& s : size) s *= 8 * epsilon;
  return size;
}

}  // namespace vcrit::simulation
