// Stiffness and v* over frequency: resonances where the undamped drive has them, asymptotes that
// the curve meets, and values by hand.
#include "compare/frequency_response.hpp"
#include "derivation/derivation.hpp"
#include "scene/scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/files.hpp"
#include "support/program.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_frequency_response)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

// k_d = 2e6 N/m, k_t = 8e6 N/m, m = 5 g: K_d = m omega^2 at 2e4 rad/s, K_t + K_d there at
// sqrt(1e7/5e-3) rad/s.
Scene elastic() {
  return test::scene_of({.tangential = "kt",
                         .network = "kd",
                         .mass = "5 g",
                         .angular_frequency = 1e5,
                         .amplitude = 1e-7,
                         .indentation = 5e-7,
                         .coefficient = 0.3,
                         .elements = {{"kn", 1e7}, {"kt", 8e6}, {"kd", 2e6}}});
}

Scene rigid() {
  return test::scene_of({.normal = "k0 | (k1 - c1)",
                         .tangential = "kt",
                         .angular_frequency = 1e5,
                         .amplitude = 1e-7,
                         .indentation = 5e-7,
                         .coefficient = 0.3,
                         .elements = {{"k0", 1e7}, {"k1", 2e7}, {"c1", 100}, {"kt", 8e6}}});
}

}  // namespace

// The search ends where neighbouring logarithms of the factor no longer differ: 40 bits of half the
// digits, 2^-20, of log(omega) at worst.
BOOST_AUTO_TEST_CASE(resonance_and_antiresonance_are_where_the_masses_swing) {
  const auto response = frequency_response(symbolic::derive(elastic()));
  BOOST_REQUIRE(response.marks.size() == 2u);
  BOOST_TEST(response.marks[0].resonance);
  BOOST_TEST(std::abs(response.marks[0].omega / 2e4 - 1) < 1e-5);
  BOOST_TEST(!response.marks[1].resonance);
  BOOST_TEST(std::abs(response.marks[1].omega / std::sqrt(1e7 / 5e-3) - 1) < 1e-5);
}

// Rows lie 1 % apart, steps of an even grid 5 %. A rigid massless drive's v* times |1 + k_t R|:
// twice it at one row, a tenth at another, and else what noise of 1 % makes of it.
BOOST_AUTO_TEST_CASE(a_measured_drive_shows_each_of_its_rows) {
  const auto at = [](int row) { return 1e5 * std::pow(1.01, row); };
  std::string rows = "omega,Re,Im\n";
  for (int row = 0; row <= 40; ++row) {
    const double noise = row % 2 == 0 ? 0.01 : -0.01, x = row == 13 ? 1 : row == 27 ? -0.9 : noise;
    rows += fmt::format("{},{},{}\n", at(row), x / 8e6, -1e-3 / 8e6);
  }
  const test::PrivateFolder folder;
  write_file(folder.path() / "drive.csv", rows);
  const Scene scene = parse_scene(test::to_toml({.tangential = "kt",
                                                 .receptance = "drive.csv",
                                                 .angular_frequency = 1.1e5,
                                                 .amplitude = 1e-7,
                                                 .indentation = 5e-7,
                                                 .coefficient = 0.3,
                                                 .elements = {{"kn", 1e7}, {"kt", 8e6}}}),
                                  (folder.path() / "scene.toml").string());
  const auto response = frequency_response(symbolic::derive(scene));
  BOOST_REQUIRE(response.marks.size() == 2u);
  BOOST_TEST(response.marks[0].resonance);
  BOOST_TEST(std::abs(response.marks[0].omega / at(13) - 1) < 1e-5);
  BOOST_TEST(!response.marks[1].resonance);
  BOOST_TEST(std::abs(response.marks[1].omega / at(27) - 1) < 1e-5);
  for (int row = 0; row <= 40; ++row)
    BOOST_TEST(std::ranges::any_of(response.points, [&](const ResponsePoint& point) {
      return std::abs(point.omega / at(row) - 1) < 1e-14;
    }));
}

// 0.3 omega 1e-7 (1e7/8e6) |1e7 - m omega^2|/|2e6 - m omega^2|: at low frequency 5 times, at high
// once 0.375e-7 omega.
BOOST_AUTO_TEST_CASE(asymptotes_are_met) {
  const auto response = frequency_response(symbolic::derive(elastic()));
  BOOST_REQUIRE(response.asymptotes.size() == 2u);
  for (const AsymptoteLine& line : response.asymptotes) {
    BOOST_TEST(line.power == 1);
    // Products and quotients of doubles, at 50 digits or not: a few roundings.
    BOOST_TEST(std::abs(line.coefficient / (line.low ? 1.875e-7 : 0.375e-7) - 1) < 1e-14);
    const ResponsePoint& end = line.low ? response.points.front() : response.points.back();
    // At a hundredth of the lowest resonance, and a hundred times the highest rate: (1/100)^2 off.
    BOOST_TEST(std::abs(end.velocity / (line.coefficient * end.omega) - 1) < 1e-2);
  }
}

// At omega = k1/c1 = 2e5: K_n = 1e7 + 2e7 i/(1 + i) = 2e7 + 1e7 i.
// (4) of a Kelvin contact: du_z sqrt(1 + (omega c/k)^2) < u_z0, so up to omega = sqrt(24) k/c here;
// (3) holds at no frequency or at all of them. Elastic a contact that may open need neither.
BOOST_AUTO_TEST_CASE(the_formula_applies_where_the_contact_stays_closed) {
  const auto of = [](test::SceneText text, double amplitude) {
    text.tangential_ratio = 0.8;
    text.amplitude = amplitude;
    text.indentation = 0.5;
    return frequency_response(symbolic::derive(test::scene_of(text)));
  };
  const test::SceneText kelvin{.normal = "kelvin(k, c)", .elements = {{"k", 3}, {"c", 2}}};
  const test::SceneText spring{.normal = "k", .separation = true, .elements = {{"k", 3}}};
  const double border = std::sqrt(24.0) * 3 / 2;
  for (const ResponsePoint& point : of(kelvin, 0.1).points)
    BOOST_TEST(point.applies == (point.omega < border), point.omega);
  for (const ResponsePoint& point : of(kelvin, 0.6).points) BOOST_TEST(!point.applies);
  for (const ResponsePoint& point : of(spring, 0.6).points) BOOST_TEST(point.applies);
}

// Where du_z is u_z0 the contact opens, also where |K_n| = 2/3 is a double below that.
BOOST_AUTO_TEST_CASE(the_formula_does_not_apply_to_an_amplitude_of_the_whole_indentation) {
  const Scene scene = test::scene_of({.normal = "k1 - k2",
                                      .tangential_ratio = 0.8,
                                      .amplitude = 0.5,
                                      .indentation = 0.5,
                                      .elements = {{"k1", 1}, {"k2", 2}}});
  for (const ResponsePoint& point : frequency_response(symbolic::derive(scene)).points)
    BOOST_TEST(!point.applies);
}

BOOST_AUTO_TEST_CASE(a_rigid_scene_has_no_drive_and_no_resonance) {
  const auto response = frequency_response(symbolic::derive(rigid()));
  BOOST_TEST(response.marks.empty());
  double nearest = 1;
  for (const ResponsePoint& point : response.points) {
    BOOST_TEST(!point.drive);
    BOOST_TEST(std::abs(point.tangential / 8e6 - 1) < 1e-15);
    // |K_n| grows with omega and by no more than omega does: as near to its value as omega.
    const double apart = std::abs(point.omega / 2e5 - 1);
    BOOST_TEST(std::abs(point.normal / std::sqrt(5e14) - 1) < apart + 1e-14);
    nearest = std::min(nearest, apart);
  }
  BOOST_TEST(nearest < 0.03);  // 48 points a decade: 2.5 percent at most to the next
}

BOOST_AUTO_TEST_SUITE_END()
