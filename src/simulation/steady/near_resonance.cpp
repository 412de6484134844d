#include "simulation/steady/near_resonance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/motion/opening.hpp"

namespace vcrit::simulation {

namespace {

// Beyond this too few digits of the motion are left to speak of.
constexpr double sharpest_resonance = 1e7;

// Events of neighbours that lie further apart than this are not the same one.
constexpr double same_event = 0.1;

// Into (-pi, pi].
double wrapped_difference(double phase) { return std::remainder(phase, two_pi); }

const Event* same(const std::vector<Event>& events, const Event& event) {
  const Event* nearest = nullptr;
  double least = same_event;
  for (const Event& other : events) {
    const double distance = std::abs(wrapped_difference(other.phase - event.phase));
    if (other.to != event.to || distance > least) continue;
    least = distance;
    nearest = &other;
  }
  return nearest;
}

[[noreturn]] void differ_in_kind() {
  throw ModelError(
      "body and drive are in or very near undamped resonance, and drives a little softer or "
      "stiffer let the contact stick and slip in other ways: the motion between them is lost in "
      "rounding");
}

}  // namespace

bool lost_in_resonance(const Model& model) { return !(model.resonance < sharpest_resonance); }

double Neighbours::mean(const std::array<double, 4>& f) const {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += weights[i] * f[i];
  return sum;
}

// The means of each two differ by O(step^2), and what is left is smaller by that once more.
double Neighbours::error(const std::array<double, 4>& f) const {
  return 10 * step * step * std::abs(f[0] + f[1] - f[2] - f[3]) / 2;
}

void too_fast_for_neighbours() {
  throw ModelError(
      "body and drive are in or very near undamped resonance, and the drive is so fast that what "
      "little stick is left is lost in rounding");
}

// The motion changes where v* comes down to the speed: with a stiffness off by the share e, v* is
// amplitude/(e m). An interpolation's error is step^4, and rounding errors grow like the inverse of
// the distance from the resonance: at this step both are about the same.
Neighbours neighbours(const System& system, const Model& model, double velocity) {
  const auto& masses = model.body->masses;
  const double mass = masses ? resonant_mass(*masses) : model.body->mass;
  const double scale = std::min(1.0, model.amplitude / (std::abs(velocity) * mass));
  Neighbours result;
  result.step = std::pow(epsilon / scale, 0.2);
  const double off = result.step * scale;
  if (!(result.step < 0.1 && 1 / off < sharpest_resonance)) too_fast_for_neighbours();
  const std::array<double, 4> shares{1 - off, 1 + off, 1 - 2 * off, 1 + 2 * off};
  for (std::size_t i = 0; i < 4; ++i) {
    result.systems[i] = system;
    if (!masses) {
      result.systems[i].drive = scaled(*system.drive, shares[i]);
      continue;
    }
    DriveStructure structure = stiffer(system.masses->structure, shares[i]);
    structure.lead.reset();  // in series with the contact already
    hold_by(result.systems[i], std::move(structure));
  }
  return result;
}

SteadyState between(const Neighbours& neighbours, const std::array<SteadyState, 4>& states) {
  const auto mean = [&](const auto& value) {
    std::array<double, 4> f{};
    for (std::size_t i = 0; i < 4; ++i) f[i] = value(states[i]);
    return std::pair(neighbours.mean(f), neighbours.error(f));
  };
  SteadyState result = states[0];
  double rounding = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (states[i].events.size() != result.events.size()) differ_in_kind();
    rounding += std::abs(Neighbours::weights[i]) * states[i].friction_ratio_error;
  }
  const auto [ratio, error] = mean([](const SteadyState& state) { return state.friction_ratio; });
  result.friction_ratio = ratio;
  result.friction_ratio_error = error + rounding;
  for (Event& event : result.events) {
    const double change =
        mean([&](const SteadyState& state) {
          const Event* other = same(state.events, event);
          return other ? wrapped_difference(other->phase - event.phase) : (differ_in_kind(), 0.0);
        }).first;
    event.phase = wrapped(event.phase + change);
  }
  std::sort(result.events.begin(), result.events.end(),
            [](const Event& a, const Event& b) { return a.phase < b.phase; });
  for (std::size_t k = 0; k < result.cycle.size(); ++k) {
    const auto of = [&](double CyclePoint::*member) {
      return mean([&](const SteadyState& state) { return state.cycle[k].*member; }).first;
    };
    result.cycle[k].contact_velocity = of(&CyclePoint::contact_velocity);
    result.cycle[k].force = of(&CyclePoint::force);
  }
  return result;
}

}  // namespace vcrit::simulation
