#include "simulation/steady/curve.hpp"

#include <algorithm>
#include <numeric>

#include "base/errors.hpp"
#include "simulation/steady/answers.hpp"

namespace vcrit::simulation {

namespace {

// From the highest speed down: just below the critical speed the cycle is simplest.
std::vector<std::size_t> falling(std::span<const double> velocities) {
  std::vector<std::size_t> order(velocities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return velocities[i] > velocities[j]; });
  return order;
}

}  // namespace

std::vector<CurvePoint> friction_curve(const System& system, std::span<const double> velocities) {
  std::vector<CurvePoint> curve(velocities.size());
  friction_curve(system, velocities, [&](std::size_t i, const PassingPoint& point) {
    if (point.state != nullptr) curve[i].state = *point.state;
    curve[i].reason = point.reason;
  });
  return curve;
}

void friction_curve(const System& system, std::span<const double> velocities,
                    const std::function<void(std::size_t, const PassingPoint&)>& use) {
  Answers answers(system);
  for (const std::size_t i : falling(velocities)) try {
      use(i, {&answers.next(velocities[i]), ""});
    } catch (const ModelError& error) {
      use(i, {nullptr, error.what()});
    }
}

}  // namespace vcrit::simulation
