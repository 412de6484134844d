#include "report/stretches.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit::validation::report {

namespace {

using simulation::CyclePoint;

}  // namespace

std::vector<MotionStretch> stretches(const std::vector<CyclePoint>& cycle, double per_phase) {
  double fastest = 0;
  for (const auto& point : cycle) fastest = std::max(fastest, std::abs(point.contact_velocity));
  const double still = 1e-12 * fastest;
  std::vector<MotionStretch> result;
  bool open = false;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const double velocity = cycle[i].contact_velocity;
    const double from = cycle[i].phase * per_phase;
    const double to = (i + 1 < cycle.size() ? cycle[i + 1].phase : two_pi) * per_phase;
    const bool backward = velocity < -still;
    if (velocity > still) {
      open = false;
    } else if (open && result.back().backward == backward) {
      result.back().to = to;
    } else {
      result.push_back({from, to, backward});
      open = true;
    }
  }
  return result;
}

}  // namespace vcrit::validation::report
