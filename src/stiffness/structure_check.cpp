#include "stiffness/structure_check.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "base/errors.hpp"

namespace vcrit {

void check_number(bool holds, std::string_view member, double value, const char* expected,
                  const char* part) {
  if (!holds || !std::isfinite(value))
    throw InputError(argument(fmt::format("{}{}", member, part)), fmt::format("{}", value),
                     expected);
}

namespace {

constexpr const char* above_zero = "a finite number above 0";
constexpr const char* at_least_zero = "a finite number of at least 0";

}  // namespace

void check_relaxation(const Relaxation& form, std::string_view member) {
  check_number(form.equilibrium >= 0, member, form.equilibrium, at_least_zero, ".equilibrium");
  check_number(form.damper >= 0, member, form.damper, at_least_zero, ".damper");
  double before = 0;
  for (const MaxwellBranch& branch : form.branches) {
    check_number(branch.stiffness >= 0, member, branch.stiffness, at_least_zero,
                 ".branches: stiffness");
    check_number(branch.time > before, member, branch.time,
                 "finite times above 0, each longer than the one before", ".branches: time");
    before = branch.time;
  }
  if (form.equilibrium == 0 && form.damper == 0 && form.branches.empty())
    throw InputError(argument(std::string(member)), "a network of nothing",
                     "a spring, a damper or a branch");
}

void require_si_doubles(bool holds) {
  if (!holds)
    throw ModelError("in SI units the numbers of this motion leave the range of doubles",
                     "Eq. (24) needs none of them; for friction give values nearer to 1");
}

void check_weights(std::size_t poles, std::size_t weights) {
  if (poles != weights)
    throw InputError(argument("weights"), fmt::format("{} for {} poles", weights, poles),
                     "one for each pole");
}

void check_sizes(const DriveStructure& structure) {
  const std::size_t n = structure.mass.size();
  const auto fits = [n](const Dense<long double>& matrix) {
    return matrix.rows() == n && matrix.columns() == n;
  };
  bool sizes = n > 0 && fits(structure.damping) && fits(structure.stiffness) &&
               structure.port.size() == n && structure.together.size() == n;
  for (const DriveBranch& branch : structure.branches) sizes = sizes && branch.pull.size() == n;
  if (!sizes)
    throw InputError(argument("drive"), "masses, matrices and vectors of different sizes",
                     "as many rows and columns as masses, one at least");
}

void check_structure(const DriveStructure& structure) {
  check_sizes(structure);
  for (const DriveBranch& branch : structure.branches) {
    check_number(branch.stiffness > 0, "drive.branches: stiffness",
                 static_cast<double>(branch.stiffness), above_zero);
    check_number(branch.time > 0, "drive.branches: time", static_cast<double>(branch.time),
                 above_zero);
  }
  for (const double mass : structure.mass) check_number(mass > 0, "drive.mass", mass, above_zero);
  if (structure.lead) check_relaxation(*structure.lead, "drive.lead");
}

}  // namespace vcrit
