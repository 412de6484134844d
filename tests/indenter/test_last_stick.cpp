// The last stick of any cell below an indenter, where some of the cells have no answer: how many
// were asked and answered is counted here by hand, as cells stand at i/64 of the half width.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "indenter/friction.hpp"
#include "indenter/half_spaces.hpp"
#include "simulation/steady/normal_force.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_last_stick)

using namespace vcrit;
using namespace vcrit::indenter;

namespace {

const HalfSpace sphere(reference::scene_of("shape = \"parabola\"\nradius = \"10 mm\"", 5e-7, 2e-7));

/// The normal force in place of the onset, as both fall outwards; no answer beyond this share of
/// the half width.
OnsetOfCell up_to(double share) {
  const double least = simulation::mean_normal_force(sphere.cell(share * sphere.edge()));
  return [least](const simulation::System& cell) {
    const double force = simulation::mean_normal_force(cell);
    if (force < least) throw ModelError("it rings");
    return simulation::Onset{force, force};
  };
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_cells_have_one) {
  const LastStick found = last_stick(sphere);
  BOOST_TEST(found.asked == 64);
  BOOST_TEST(found.answered == 64);
}

BOOST_AUTO_TEST_CASE(cells_without_one_are_counted) {
  const LastStick found = last_stick(sphere, up_to(0.9));
  BOOST_TEST(found.asked == 64);
  BOOST_TEST(found.answered == 58);  // 0 to 57, 0.9 x 64 = 57.6
  BOOST_TEST(found.x <= 1e-6 * sphere.edge());
}

BOOST_AUTO_TEST_CASE(with_too_few_answers_there_is_none) {
  BOOST_TEST(test::refused<ModelError>([] { last_stick(sphere, up_to(0.5)); },
                                       "of 64 cells 33 have a steady state; of one of the others "
                                       "it rings"));
}

BOOST_AUTO_TEST_SUITE_END()
