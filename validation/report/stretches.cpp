#include "report/stretches.hpp"

#include <algorithm>

#include "base/constants.hpp"

namespace vcrit::validation::report {

using simulation::Event;
using simulation::Motion;

std::vector<MotionStretch> stretches(const Cycle& cycle, double per_phase) {
  std::vector<MotionStretch> result;
  const auto add = [&](double from, double to, bool backward) {
    if (to > from) result.push_back({from * per_phase, to * per_phase, backward});
  };
  if (cycle.events.empty() && cycle.regime == to_text(simulation::Regime::stick))
    add(0, two_pi, false);
  for (std::size_t i = 0; i < cycle.events.size(); ++i) {
    const Event& event = cycle.events[i];
    if (event.to != Motion::stick && event.to != Motion::backslip) continue;
    const bool last = i + 1 == cycle.events.size(), backward = event.to == Motion::backslip;
    if (!last) {
      add(event.phase, cycle.events[i + 1].phase, backward);
      continue;
    }
    add(event.phase, two_pi, backward);
    add(0, cycle.events.front().phase, backward);
  }
  std::sort(result.begin(), result.end(),
            [](const MotionStretch& a, const MotionStretch& b) { return a.from < b.from; });
  return result;
}

}  // namespace vcrit::validation::report
