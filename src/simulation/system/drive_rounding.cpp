#include "simulation/system/drive_rounding.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "modes/general_modes.hpp"
#include "stiffness/dynamic_matrix.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::simulation {

void parts_too_different() {
  throw ModelError(
      "parts of the drive are so different in stiffness, damping or mass that rounding hides "
      "what moves the body",
      "leave the stiffest links out, which join masses to one, and the lightest masses");
}

namespace {

double lead_stiffness(const Relaxation& form, double s) {
  double sum = form.equilibrium + form.damper * s;
  for (const MaxwellBranch& branch : form.branches)
    sum += branch.stiffness / (1 + 1 / (s * branch.time));
  return sum;
}

}  // namespace

// All is asked at s = omega: on the positive real axis nothing resonates, so that a digit is lost
// for no other reason.
double drive_rounding(const DriveStructure& structure, const DriveMotion& motion,
                      const Relaxation& contact, double omega, std::optional<double> compliance) {
  constexpr double most = 1e-4;           // to first order: beyond it nothing tells what is lost
  constexpr double usual = 16 * epsilon;  // of the doubles here
  if (!(omega > 0)) return 0;
  const RoundedReceptance right = rounded_receptance(structure, omega);
  const double receptance = static_cast<double>(right.value.real()),
               found = response(motion.rates, omega)[0].real() / omega / motion.mass,
               all = std::abs(receptance) + 1 / std::abs(dynamic_stiffness(contact, omega)),
               lead = structure.lead ? 1 / lead_stiffness(*structure.lead, omega) : 0,
               lost = compliance ? std::abs(lead + found - *compliance) : 0,
               off =
                   std::max({static_cast<double>(right.error), std::abs(found - receptance), lost}),
               share = off / all;
  require_si_doubles(!std::isnan(share));
  if (share > most) parts_too_different();
  return share > usual ? share : 0;
}

}  // namespace vcrit::simulation
