#include "answers/ringing.hpp"

#include <algorithm>
#include <cmath>

#include "stiffness/dynamic_matrix.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

constexpr int last_harmonic = 100;

// Displacement per force of the body's end, which drive and contact hold.
std::complex<double> stuck_way(const DriveStructure& structure, std::complex<double> contact,
                               double omega) {
  const auto ways = displacements(structure, {0, omega});
  std::complex<long double> way = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) way += structure.port[i] * ways[i];
  const std::complex<double> free(static_cast<double>(way.real()), static_cast<double>(way.imag()));
  return 1.0 / (1.0 / free + contact);
}

double ringing_of_masses(const simulation::System& system) {
  DriveStructure at_rest = system.masses->structure;
  at_rest.mass.assign(at_rest.mass.size(), 0);
  double most = 1;
  for (int n = 1; n <= last_harmonic; ++n) {
    const double s = n * system.omega;
    const auto contact = dynamic_stiffness(system.contact, s);
    most = std::max(most, std::abs(stuck_way(system.masses->structure, contact, s)) /
                              std::abs(stuck_way(at_rest, contact, s)));
  }
  return most;
}

}  // namespace

double ringing(const simulation::System& system) {
  if (system.masses) return ringing_of_masses(system);
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
