#include "simulation/motion/opening.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

// The contact neither closes nor opens for a shorter time than this: the force, or the gap, would
// be a rounding error of its amplitude.
constexpr double shortest = 1e-9;

// With more of the mean force in doubt there is no digit of friction, which is measured by it.
constexpr double most_error = 0.1;

double until(double phase, double t) {
  const double result = wrapped(phase - t);
  return result < two_pi - shortest ? result : 0;
}

}  // namespace

Opening::Opening(const NormalMotion& motion, double omega, SharedEffort* whole) {
  const ContactModes network = modes_of(motion, omega);
  jumps = network.damper > 0;
  answers_at_once = simulation::answers_at_once(motion, omega);
  const NormalCycle cycle = normal_cycle(network, {motion.mean, motion.amplitude}, whole);
  if (cycle.touches.empty()) throw ModelError("the contact never closes: there is no friction");
  if (!(cycle.error < most_error * cycle.mean))
    throw ModelError(
        "the contact carries so little of the force with which it is pressed that its mean normal "
        "force is lost in rounding",
        "a stiffer spring of the normal network carries more");
  mean_force = cycle.mean;
  error = cycle.error / cycle.mean;
  amplitude = std::abs(cycle.swing) / cycle.mean;
  phase = std::arg(cycle.swing);
  closed = cycle.touches.size() == 1 && cycle.touches.front().duration > two_pi - shortest;
  if (closed) return;
  constant = cycle.touches.front().decays[0] / cycle.mean;
  rates.assign(network.branch_rates.begin() + 1, network.branch_rates.end());
  for (const NormalCycle::Touch& touch : cycle.touches) {
    Vector decaying(touch.decays.begin() + 1, touch.decays.end());
    for (double& part : decaying) part /= cycle.mean;
    touches.push_back({wrapped(touch.begin + phase), touch.duration, std::move(decaying)});
  }
  std::sort(touches.begin(), touches.end(),
            [](const Touch& a, const Touch& b) { return a.begin < b.begin; });
}

double Opening::until_opened(Index touch, double t) const {
  return until(touches[touch].begin + touches[touch].duration, t);
}

double Opening::until_closed(Index touch, double t) const { return until(touches[touch].begin, t); }

double Opening::part(Index i, Index touch, double t) const {
  const double since = wrapped(t - touches[touch].begin);
  const double passed = since < two_pi - shortest ? since : 0;
  return touches[touch].decaying[i] * std::exp(-rates[i] * passed);
}

double Opening::decaying(Index touch, double t, int derivative) const {
  double sum = 0;
  for (Index i = 0; i < rates.size(); ++i)
    sum += std::pow(-rates[i], derivative) * part(i, touch, t);
  return sum;
}

Opening::Middle Opening::middle() const {
  Middle result;
  double longest = 0;
  for (Index i = 0; i < touches.size(); ++i) {
    const Index before = (i == 0 ? touches.size() : i) - 1;
    const double opened = touches[before].begin + touches[before].duration;
    const double separation = until_closed(i, opened);
    if (separation <= longest) continue;
    longest = separation;
    result = {wrapped(opened + 0.5 * separation), i};
  }
  ensure(longest > 0, "the contact opens");
  return result;
}

}  // namespace vcrit::simulation
