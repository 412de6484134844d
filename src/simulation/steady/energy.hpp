// Where the work of the drive goes in one period of the steady motion: heat of friction and of the
// dampers of contact and drive. All three come from the motion itself, apart from each other, so
// that their balance tries it.
#pragma once

#include <optional>

#include "simulation/steady/exact.hpp"

namespace vcrit::simulation {

/// In one oscillation period, of the tangential motion: what moves the body up and down is not in
/// it.
struct EnergyBalance {
  double drive = 0;     ///< J, work of the drive
  double friction = 0;  ///< J, dissipated where the contact slips
  double dampers = 0;   ///< J, dissipated in the networks of contact and drive
  double error = 0;     ///< J, estimate of the error of each; what the balance may miss
};

/// velocity: mean velocity of the drive, m/s, > 0. Nothing where no double holds it, and where the
/// body swings on its own more than some 16,000 times a period without coming to rest: following it
/// would take too long. Throws ModelError where no steady state is found.
std::optional<EnergyBalance> energy_balance(const System& system, double velocity);

}  // namespace vcrit::simulation
