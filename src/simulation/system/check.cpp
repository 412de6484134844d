#include "simulation/system/check.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

void check_number(bool holds, const std::string& member, double value, const char* expected) {
  if (!holds || !std::isfinite(value))
    throw InputError(argument(member), fmt::format("{}", value), expected);
}

constexpr const char* above = "a finite number above 0";
constexpr const char* at_least = "a finite number of at least 0";

void check_form(const Relaxation& form, const std::string& member) {
  check_number(form.equilibrium >= 0, member + ".equilibrium", form.equilibrium, at_least);
  check_number(form.damper >= 0, member + ".damper", form.damper, at_least);
  double before = 0;
  for (const MaxwellBranch& branch : form.branches) {
    check_number(branch.stiffness >= 0, member + ".branches: stiffness", branch.stiffness,
                 at_least);
    check_number(branch.time > before, member + ".branches: time", branch.time,
                 "finite times above 0, each longer than the one before");
    before = branch.time;
  }
  if (form.equilibrium == 0 && form.damper == 0 && form.branches.empty())
    throw InputError(argument(member), "a network of nothing", "a spring, a damper or a branch");
}

void check_normal_force(const System& system) {
  const double mean = system.mean_normal_force, swing = std::abs(system.normal_force_amplitude);
  check_number(mean > 0, "mean_normal_force", mean, above);
  if (!(swing <= (1 + epsilon) * mean))
    throw InputError(
        argument("normal_force_amplitude"), fmt::format("{} N about a mean of {} N", swing, mean),
        "an amplitude up to the mean", "of a contact that opens give opening in place of both");
}

void check_opening(const NormalMotion& opening) {
  check_form(opening.network, "opening.network");
  check_number(opening.network.equilibrium > 0, "opening.network.equilibrium",
               opening.network.equilibrium, above);
  check_number(true, "opening.mean", opening.mean, "a finite number");
  check_number(opening.amplitude > 0, "opening.amplitude", opening.amplitude, above);
}

}  // namespace

void check_structure(const DriveStructure& structure) {
  const std::size_t n = structure.mass.size();
  const auto fits = [n](const Dense<long double>& matrix) {
    return matrix.rows() == n && matrix.columns() == n;
  };
  bool sizes = n > 0 && fits(structure.damping) && fits(structure.stiffness) &&
               structure.port.size() == n && structure.together.size() == n;
  for (const DriveBranch& branch : structure.branches) {
    sizes = sizes && branch.pull.size() == n;
    check_number(branch.stiffness > 0, "drive.branches: stiffness",
                 static_cast<double>(branch.stiffness), above);
    check_number(branch.time > 0, "drive.branches: time", static_cast<double>(branch.time), above);
  }
  if (!sizes)
    throw InputError(argument("drive"), "masses, matrices and vectors of different sizes",
                     "as many rows and columns as masses, one at least");
  for (const double mass : structure.mass) check_number(mass > 0, "drive.mass", mass, above);
  if (structure.lead) check_form(*structure.lead, "drive.lead");
}

void check_system(const System& system) {
  check_form(system.contact, "contact");
  if (system.drive) check_form(*system.drive, "drive");
  if (system.mass) check_number(*system.mass >= 0, "mass", *system.mass, at_least);
  check_number(system.omega > 0, "omega", system.omega, above);
  check_number(system.friction > 0, "friction", system.friction, above);
  system.opening ? check_opening(*system.opening) : check_normal_force(system);
}

}  // namespace vcrit::simulation
