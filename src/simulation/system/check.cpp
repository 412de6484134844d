#include "simulation/system/check.hpp"

#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::simulation {

namespace {

constexpr const char* positive_number = "a finite number above 0";

void check_normal_force(const System& system) {
  const double mean = system.mean_normal_force, swing = std::abs(system.normal_force_amplitude);
  check_number(mean > 0, "mean_normal_force", mean, positive_number);
  if (swing <= (1 + epsilon) * mean) return;
  const auto [swing_words, mean_words] = rounded_apart(swing, mean, "N");
  throw InputError(argument("normal_force_amplitude"),
                   swing_words + " about a mean of " + mean_words, "an amplitude up to the mean",
                   "of a contact that opens give opening in place of both");
}

void check_opening(const NormalMotion& opening) {
  check_relaxation(opening.network, "opening.network");
  check_number(opening.network.equilibrium > 0, "opening.network.equilibrium",
               opening.network.equilibrium, positive_number);
  check_number(true, "opening.mean", opening.mean, "a finite number");
  check_number(opening.amplitude > 0, "opening.amplitude", opening.amplitude, positive_number);
}

}  // namespace

void check_system(const System& system) {
  check_relaxation(system.contact, "contact");
  if (system.drive) check_relaxation(*system.drive, "drive");
  if (system.mass)
    check_number(*system.mass >= 0, "mass", *system.mass, "a finite number of at least 0");
  check_number(system.omega > 0, "omega", system.omega, positive_number);
  check_number(system.friction > 0, "friction", system.friction, positive_number);
  system.opening ? check_opening(*system.opening) : check_normal_force(system);
}

}  // namespace vcrit::simulation
