// Where the contact just opens: v* goes on from that of Eq. (24) without a hole, however little
// they part. With a rigid drive Eq. (24) is mu0 omega du_z |K_n|/|K_t|, here from sums of complex
// numbers.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "base/errors.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_border_of_opening)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

// omega = 1.
std::complex<double> stiffness(const Relaxation& form) {
  std::complex<double> sum(form.equilibrium, form.damper);
  for (const MaxwellBranch& branch : form.branches)
    sum += branch.stiffness / (1.0 + 1.0 / std::complex<double>(0, branch.time));
  return sum;
}

// The contact would pull by the share 10^-k of the mean force.
System just_parting(const Relaxation& normal, const Relaxation& contact, int k) {
  System system;
  system.contact = contact;
  system.omega = system.friction = 1;
  const double amplitude =
      normal.equilibrium / std::abs(stiffness(normal)) * (1 + std::pow(10, -k));
  system.mean_normal_force = normal.equilibrium;
  system.normal_force_amplitude = amplitude * stiffness(normal);
  system.opening = {normal, 1, amplitude};
  return system;
}

// Separation changes the force by no more than what a closed contact would pull with, on either
// side, and so v* by no more than twice that share, beside rounding.
void check(const Relaxation& normal, const Relaxation& contact, const std::string& name) {
  for (int k = 4; k <= 15; ++k) {
    const System system = just_parting(normal, contact, k);
    const double closed = std::abs(system.normal_force_amplitude) / std::abs(stiffness(contact));
    Onset found;
    BOOST_TEST_CONTEXT(name << " at 1e-" << k)
    BOOST_CHECK_NO_THROW(found = sliding_threshold(system));
    BOOST_TEST(std::abs(found.contact_velocity / closed - 1) <= 2 * std::pow(10, -k) + 1e-12,
               name << " at 1e-" << k << ": " << found.contact_velocity / closed - 1);
    // What is taken for closed says what that leaves out.
    BOOST_TEST(found.uncertainty <= 2 * std::pow(10, -k) * closed + 1e-12 * closed);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(v_star_has_no_hole_where_the_contact_hardly_opens) {
  constexpr unsigned seed = 32;
  BOOST_TEST_MESSAGE("seed " << seed);
  reference::RandomSystems random(seed, 3);
  const Relaxation contact{1.3, 0.7, {}};
  check({1, 0.08, {{0.3, 2}}}, contact, "a damper and a branch");
  check({1, 0.15, {{0.05, 0.1}, {0.3, 2}}}, contact, "a damper and two branches");
  check({1, 0.022, {}}, contact, "a damper");
  for (int i = 0; i < 40; ++i) check(random.network(true), contact, "network " + std::to_string(i));
}

// The normal force jumps where a normal network with a damper closes, and a tangential one without
// cannot follow.
BOOST_AUTO_TEST_CASE(without_a_damper_beside_it_a_jump_leaves_no_v_star) {
  for (int k = 4; k <= 15; ++k)
    BOOST_TEST(std::isinf(
        sliding_threshold(just_parting({1, 0.3, {}}, {1, 0, {{2, 1}}}, k)).contact_velocity));
}

// Friction as that of the closed contact beside the border, whose amplitude is off by the share.
BOOST_AUTO_TEST_CASE(friction_goes_on_from_that_of_a_closed_contact) {
  const Relaxation normal{1, 0.15, {{0.05, 0.1}, {0.3, 2}}}, contact{1.3, 0.7, {}};
  System closed = just_parting(normal, contact, 16);
  closed.opening.reset();
  closed.normal_force_amplitude *= (1 - 1e-15) / std::abs(closed.normal_force_amplitude);
  const double velocity = 0.5 * sliding_threshold(closed).drive_velocity;
  const double ratio = steady_state(closed, velocity).friction_ratio;
  for (int k = 6; k <= 15; ++k) {
    const SteadyState found = steady_state(just_parting(normal, contact, k), velocity);
    BOOST_TEST(std::abs(found.friction_ratio - ratio) <=
                   found.friction_ratio_error + 10 * std::pow(10, -k) + 1e-12,
               k);
  }
}

BOOST_AUTO_TEST_SUITE_END()
