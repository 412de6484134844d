#include "answers/ringing.hpp"

#include <algorithm>
#include <cmath>

#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

double ringing(const simulation::System& system) {
  constexpr int last_harmonic = 100;
  double most = 1;
  for (int n = 1; system.drive && system.mass && n <= last_harmonic; ++n) {
    const double s = n * system.omega;
    const auto stiffness =
        dynamic_stiffness(system.contact, s) + dynamic_stiffness(*system.drive, s);
    most = std::max(most, std::abs(stiffness) / std::abs(stiffness - *system.mass * s * s));
  }
  return most;
}

}  // namespace vcrit
