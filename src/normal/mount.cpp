#include "normal/mount.hpp"

#include <cmath>

#include "base/constants.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

std::complex<long double> mount_response(const Problem& problem, double omega) {
  if (!problem->mount) return 1;
  const Values& values = problem.values();
  const auto mount = wide_dynamic_stiffness(problem->mount->reduction(), values, omega);
  auto whole = mount + wide_dynamic_stiffness(problem->normal.reduction(), values, omega);
  // Three doubles have more digits than a long double; what is left is far below one of v*, but
  // next to a resonance without damping.
  if (problem->mount_mass)
    whole -= static_cast<long double>(values.at(problem->mount_mass->symbol)) * omega * omega;
  return mount / whole;
}

double mount_factor(const Problem& problem, double omega) {
  return static_cast<double>(std::abs(mount_response(problem, omega)));
}

double contact_amplitude(const Problem& problem) {
  const double amplitude = problem.value(problem->amplitude);
  if (!problem->mount || amplitude == 0) return amplitude;
  return amplitude * mount_factor(problem, problem.value(problem->angular_frequency));
}

double mount_phase(const Problem& problem) {
  const auto response = mount_response(problem, problem.value(problem->angular_frequency));
  if (!std::isfinite(std::abs(response))) return -pi / 2;
  return static_cast<double>(std::arg(response));
}

}  // namespace vcrit
