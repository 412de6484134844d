// Condition numbers by hand: what relative errors of a scene's numbers move v* by, at most. mu0,
// omega and du_z count once each, |K_n| and |K_t| sqrt(2) times; |D| and |N| by their parts.
#include "critical/conditioning.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "problem/problem.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_conditioning)

namespace {

using namespace vcrit;

constexpr double root = std::numbers::sqrt2;

double condition(test::Toml drive, test::Toml mass, double kd) {
  const Scene scene = test::scene_of({.tangential = "kt",
                                      .network = drive,
                                      .mass = mass,
                                      .elements = {{"kn", 3}, {"kt", 5}, {"kd", kd}}});
  return condition_number(scene, resolve(scene).values());
}

bool is(double value, double expected) { return std::abs(value / expected - 1) <= 1e-14; }

}  // namespace

BOOST_AUTO_TEST_CASE(known_by_hand) {
  BOOST_TEST(is(condition({}, {}, 0), 3 + 2 * root));
  // D = K_d, N = K_t + K_d.
  BOOST_TEST(is(condition("kd", {}, 7), 3 + 4 * root));
  // m omega^2 = 4 counts three times: D = 7 - 4, N = 5 + 7 - 4.
  BOOST_TEST(is(condition("kd", 1, 7), 3 + 2 * root + (7 * root + 12) / 3 + (12 * root + 12) / 8));
  // Near resonance as its distance, 2^-20, says.
  BOOST_TEST(is(condition("kd", 1, 4.00000095367431640625),
                3 + 2 * root + (4.00000095367431640625 * root + 12) * 0x1p20 +
                    (9.00000095367431640625 * root + 12) / 5.00000095367431640625));
}

// Under a mount K_m of 9, and a mass of the mount whose m omega^2 is 4, counted three times:
// |K_m|/|K_m + K_n - m omega^2| adds root and the parts of 9 + 3 - 4.
BOOST_AUTO_TEST_CASE(a_mount_counts) {
  const auto mounted = [](test::Toml mass) {
    const Scene scene = test::scene_of({.tangential = "kt",
                                        .mount = "km",
                                        .mount_mass = mass,
                                        .elements = {{"kn", 3}, {"kt", 5}, {"km", 9}}});
    return condition_number(scene, resolve(scene).values());
  };
  BOOST_TEST(is(mounted({}), 3 + 3 * root + root));
  BOOST_TEST(is(mounted(1), 3 + 3 * root + (12 * root + 12) / 8));
}

// Halfway between two rows: R = 0.15 m/N. The shares of the rows count by omega/(3 - 1) |R_2 - R_1|
// = 0.1, the rows themselves by 0.15 and three roundings by 0.45: 0.7, times 5/(1 + 5 R).
BOOST_AUTO_TEST_CASE(rows_of_a_measured_drive_count) {
  Scene scene = test::scene_of(
      {.tangential = "kt", .network = "kd", .elements = {{"kn", 3}, {"kt", 5}, {"kd", 7}}});
  scene.drive.reset();
  scene.receptance = Receptance{"r.csv", {{1, 0.1, 0}, {3, 0.2, 0}}};
  std::erase_if(scene.elements, [](const auto& element) { return element.first.name == "kd"; });
  scene.typed.clear();
  BOOST_TEST(is(condition_number(scene, resolve(scene).values()), 3 + 2 * root + 5 * 0.7 / 1.75));
  // m omega^2 = 4: D = 1 - 4 R, and N = 5 R + D.
  scene.mass = {{{"m"}, 1}};
  BOOST_TEST(is(condition_number(scene, resolve(scene).values()),
                3 + 2 * root + 4 * 0.7 / 0.4 + 9 * 0.7 / 1.15));
}

// What two ways to v* may be apart by: 32 x 2^-53 = 2^-48 for each unit of the condition number, as
// far as that is above the simulator's promise.
BOOST_AUTO_TEST_CASE(tolerances_grow_with_the_condition_number) {
  BOOST_TEST(formula_tolerance(6) == 6 * 0x1p-48);
  BOOST_TEST(motion_tolerance(1e3) == 1e-9);
  BOOST_TEST(motion_tolerance(1e8) == 1e8 * 0x1p-48);
  BOOST_TEST(leaves_digits(motion_tolerance(0x1p47)));
  BOOST_TEST(!leaves_digits(motion_tolerance(0x1p48)));
}

BOOST_AUTO_TEST_SUITE_END()
