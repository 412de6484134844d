// What the drive does is what friction and dampers take, in every steady motion: slip, stick-slip,
// creep.
#include <cmath>

#include "property.hpp"
#include "random_systems.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_energy_balance)

namespace {

using namespace vcrit;
using namespace vcrit::properties;
using namespace vcrit::simulation;

EnergyBalance balance_of(const Draw& draw, double ratio) {
  const System system = properties::system_of(draw);
  return energy_balance(system, drive_velocity(system, ratio)).value();
}

void check_balance(const EnergyBalance& energy, double tolerance) {
  RC_ASSERT(energy.friction >= 0);
  RC_ASSERT(energy.dampers >= 0);
  RC_ASSERT(std::abs(energy.drive - energy.friction - energy.dampers) <= tolerance * energy.drive);
}

}  // namespace

// The contact velocity is known to some 10 u of its terms, which are up to 1/ratio times v0 and
// more where contact or drive are soft beside the other: 1e-10 leaves 1e5 for both.
RC_BOOST_PROP(closes_in_stick_slip, ()) {
  const auto draw = *draws(1);
  const auto ratio = *ratio_below_one();
  check_balance(balance_of(draw, ratio), 1e-10);
}

RC_BOOST_PROP(closes_in_sliding, ()) {
  const auto draw = *draws(1);
  check_balance(balance_of(draw, 1 + *magnitude(3)), 1e-10);
}

// Over many decades, to its own error.
RC_BOOST_PROP(closes_within_its_error, ()) {
  const auto draw = *draws(6);
  const auto ratio = *ratio_below_one();
  const EnergyBalance energy = balance_of(draw, ratio);
  check_balance(energy, energy.error / energy.drive);
}

BOOST_AUTO_TEST_SUITE_END()
