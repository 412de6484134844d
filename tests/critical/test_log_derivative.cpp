// Relative sensitivities of Eq. (24): in doubles, by balls, and by values known by hand.
#include "critical/log_derivative.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "base/errors.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "problem/problem.hpp"
#include "support/nodal.hpp"
#include "support/program.hpp"
#include "support/random_scene.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_log_derivative)

namespace {

using namespace vcrit;

const Scene absorber = read_scene(VCRIT_TEST_DATA "/range_ends/absorber_sensitivity.toml");

Scene with(Scene scene, const std::string& element, double factor) {
  for (auto& [symbol, value] : scene.elements)
    if (symbol.name == element) *value *= factor;
  return scene;
}

// The absorber stands still for the body: v* is that of a rigid drive, whatever kd; what ka adds
// comes from a pole on both sides of the quotient.
BOOST_AUTO_TEST_CASE(a_tuned_absorber) {
  BOOST_TEST(log_derivative(absorber, {"kd"}) == 0);
  BOOST_TEST(std::abs(log_derivative(absorber, {"ka"}) + 0.7) <= 1e-15);
  BOOST_TEST(std::abs(log_derivative(absorber, {"ma"}) - 0.7) <= 1e-15);
}

// A second derivative of order 1, so that the change is of the order of the detuning.
BOOST_AUTO_TEST_CASE(next_to_it) {
  for (const double detuning : {1e-6, -1e-9, 1e-12, -1e-15}) {
    const Scene beside = with(absorber, "ka", 1 + detuning);
    const double off = 100 * std::abs(detuning) + 1e-15;
    BOOST_TEST(std::abs(log_derivative(beside, {"ka"}) + 0.7) <= off);
    BOOST_TEST(std::abs(log_derivative(beside, {"kd"})) <= off);
  }
}

BOOST_AUTO_TEST_CASE(doubles_against_balls) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Scene scene = test::RandomScenes(4200 + seed, 2).scene(6);
    for (const auto& [symbol, value] : scene.elements) {
      const double balls = certified_log_derivative(scene, symbol);
      // Some 1e3 roundings, near a resonance as many times more as v* answers to the element.
      BOOST_TEST(std::abs(log_derivative(scene, symbol) - balls) <= 1e-12 * (1 + balls * balls),
                 "seed " << seed << ", " << to_text(symbol));
    }
  }
}

// Masses, springs and dampers of the drive, by differences of nodal analysis at 250 digits. x is
// 2^-50 from two neighbours, between which v* bends by the square of its sensitivity, times 2^-100.
BOOST_AUTO_TEST_CASE(drives_with_masses_against_nodes) {
  test::RandomScenes random(77, 2);
  int masses = 0;
  for (int i = 0; i < 40; ++i) {
    Scene scene = random.scene(3);
    scene.mass.reset();
    scene.drive = random.drive_with_masses(1 + i % 3, scene);
    for (const Symbol& symbol : symbols_of(*scene.drive)) {
      const double x = resolve(scene).values().at(symbol), low = x * (1 - 0x1p-50),
                   high = x * (1 + 0x1p-50);
      const auto at = [&](double value) {
        for (auto& [name, number] : scene.elements)
          if (name == symbol) number = value;
        return test::critical_velocity_by_nodes(scene);
      };
      const test::Real change = at(high) - at(low), v = at(x);
      const auto expected =
          static_cast<double>(test::Real(change / v * (test::Real(x) / (test::Real(high) - low))));
      masses += symbol.name.starts_with("md") ? 1 : 0;
      BOOST_TEST(std::abs(log_derivative(scene, symbol) - expected) <=
                     1e-14 * (1 + std::abs(expected) + expected * expected),
                 "scene " << i << ", " << to_text(symbol));
    }
  }
  BOOST_TEST(masses > 50);
}

// A measured contact follows omega: by differences of v* over parts of 1e-6 of omega. Rounding of
// v*, some 1e2 units, over twice that, and the change's square leave less than 1e-7. Drives with
// and without masses go two ways.
BOOST_AUTO_TEST_CASE(a_measured_contact_follows_omega) {
  const test::PrivateFolder folder;
  std::ofstream(folder.path() / "pad.csv") << "omega,storage,loss\n1,8,1\n3,16,2\n5,16,4\n";
  for (const char* drive : {"kd | cd", "kd | ka - mass(ma)"}) {
    const Problem problem = parse_problem(
        "[contact]\ndynamic_stiffness = \"pad.csv\"\nstatic_stiffness = 6\npoisson = 0.3\n"
        "[drive]\nnetwork = \"" +
            std::string(drive) +
            "\"\n[oscillation]\nangular_frequency = 2\namplitude = 1e-6\nindentation = 9e-6\n"
            "[friction]\ncoefficient = 0.3\n[elements]\nkd = 5\ncd = 1\nka = 3\nma = 0.1\n",
        folder.path() / "s.toml", {});
    constexpr double part = 1e-6;
    const auto at = [&](double factor) {
      return critical_velocity(problem.with({{{"omega"}, 2 * factor}}));
    };
    const double slope = std::log(at(1 + part) / at(1 - part)) / (2 * part);
    BOOST_TEST(std::abs(log_derivative(problem, {"omega"}) - slope) <= 1e-7);
    BOOST_CHECK_THROW(log_derivative(problem.with({{{"omega"}, 3}}), {"omega"}), ModelError);
  }
}

BOOST_AUTO_TEST_CASE(no_sensitivity_of_what_is_0_or_infinite) {
  const Scene resonant = test::scene_of({.tangential = "kt",
                                         .network = "kd",
                                         .mass = 2,
                                         .elements = {{"kn", 3}, {"kt", 4}, {"kd", 8}}});
  BOOST_CHECK_THROW(log_derivative(resonant, {"kt"}), ModelError);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
