// v* under drives with masses of their own: against an independent dense nodal solution with 250
// digits, and exact at the resonances of the drive and of its parts.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "problem/problem.hpp"
#include "problem/variants.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_masses)

using namespace vcrit;

namespace {

/// kn = 3, mu0 = 1/2, du_z = 1; the drive, its elements and the rest as given.
Scene scene(double omega, double kt, const std::string& drive, const test::Elements& elements,
            const test::Toml& mass = {}, const std::string& networks = {}) {
  test::SceneText text{.tangential = "kt",
                       .network = drive,
                       .mass = mass,
                       .angular_frequency = omega,
                       .amplitude = 1,
                       .indentation = 2,
                       .elements = {{"kn", 3}, {"kt", kt}},
                       .more = networks};
  text.elements.insert(text.elements.end(), elements.begin(), elements.end());
  return test::scene_of(text);
}

double certified(const Scene& scene) {
  return certified_critical_velocity(as_doubles(scene)).value;
}

const std::string horn =
    "[networks.horn]\nterminals = [\"body\", \"housing\"]\n"
    "edges = [[\"k1\", \"body\", \"1\"], [\"mass(m1)\", \"1\", \"ground\"],\n"
    "[\"k2\", \"1\", \"2\"], [\"mass(m2)\", \"2\", \"housing\"], [\"c2\", \"2\", \"housing\"],\n"
    "[\"k3\", \"body\", \"2\"], [\"k4\", \"2\", \"housing\"], [\"k5 - mass(m3)\", \"1\", "
    "\"ground\"]]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_chain_of_three_bodies_and_a_graph_are_what_nodal_analysis_gives) {
  const Scene chain = scene(1.7, 4.1, "mass(m) | k1 - (mass(m2) | c1 | k2 - (mass(m3) | c3 | k3))",
                            {{"m", 0.3},
                             {"k1", 2.3},
                             {"m2", 1.1},
                             {"c1", 0.2},
                             {"k2", 5},
                             {"m3", 0.7},
                             {"c3", 0.1},
                             {"k3", 1}});
  const Scene wired = scene(1.7, 4.1, "horn",
                            {{"k1", 2.3},
                             {"m1", 1.1},
                             {"k2", 5},
                             {"m2", 0.7},
                             {"c2", 0.1},
                             {"k3", 1.9},
                             {"k4", 0.6},
                             {"k5", 0.8},
                             {"m3", 0.2}},
                            0.4, horn);
  for (const Scene& s : {chain, wired}) {
    BOOST_TEST(certified(s) == static_cast<double>(test::critical_velocity_by_nodes(s)));
    BOOST_TEST(s.warnings.empty());
  }
}

BOOST_AUTO_TEST_CASE(random_masses_round_like_nodal_analysis_at_250_digits) {
  test::RandomScenes random(31, 4);
  int graphs = 0, doubles = 0;
  for (int i = 0; i < 200; ++i) {
    Scene s = random.scene(4);
    s.drive = random.drive_with_masses(1 + i % 4, s);
    graphs += std::holds_alternative<Graph>(s.drive->form) ? 1 : 0;
    const CertifiedVelocity velocity = certified_critical_velocity(s);
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(velocity.value == static_cast<double>(test::critical_velocity_by_nodes(s)));
      BOOST_TEST(velocity.relative_error_bound == std::numeric_limits<double>::epsilon() / 2);
      // K(i omega) in doubles: nine roundings a step at most, each grown by what `sensitivity`
      // says.
      const Values values = resolve(s).values();
      const double omega = values.at(s.angular_frequency.symbol);
      const Reduction reduction = reduce(*s.drive);
      const auto found = dynamic_stiffness(reduction, values, omega);
      const test::Complex exact = test::Nodal(values, test::Real(omega)).stiffness(*s.drive);
      const double bound = 16 * 0x1p-53 * sensitivity(reduction, values, omega) / std::abs(found);
      doubles += bound < 1e-10 ? 1 : 0;
      if (bound < 1e-3) BOOST_TEST(test::relative_error(found, exact) <= bound);
    }
  }
  BOOST_TEST(graphs > 50);
  BOOST_TEST(doubles > 100);
}

BOOST_AUTO_TEST_CASE(a_body_is_a_mass_at_the_near_end_of_the_drive) {
  for (const double omega : {0.3, 1.9, 2.0, 77.7}) {
    const Scene body = scene(omega, 4, "kd | cd", {{"kd", 5.2}, {"cd", 0.01}}, 1.3);
    const Scene inside =
        scene(omega, 4, "mass(m) | kd | cd", {{"kd", 5.2}, {"cd", 0.01}, {"m", 1.3}});
    BOOST_TEST(!inside.mass.has_value());
    BOOST_TEST(certified(body) == certified(inside));
  }
}

// m0 = 1, m1 = 2, k1 = 2, k2 = 4: 2 (lambda - 1)(lambda - 4) is the determinant of the chain.
BOOST_AUTO_TEST_CASE(a_chain_of_two_masses_has_two_resonances) {
  const std::string chain = "k1 - (mass(m1) | k2)";
  for (const double omega : {1.0, 2.0}) {
    const auto velocity =
        certified_critical_velocity(scene(omega, 4, chain, {{"k1", 2}, {"m1", 2}, {"k2", 4}}, 1));
    BOOST_TEST(std::isinf(velocity.value));
    BOOST_TEST(velocity.reason.find("resonance: K_d = m omega^2") != std::string::npos);
    const auto inside = certified_critical_velocity(scene(
        omega, 4, "mass(m) | k1 - (mass(m1) | k2)", {{"m", 1}, {"k1", 2}, {"m1", 2}, {"k2", 4}}));
    BOOST_TEST(std::isinf(inside.value));
    BOOST_TEST(inside.reason.find("resonance: K_d = 0") != std::string::npos);
  }
  BOOST_TEST(std::isfinite(certified(scene(1.5, 4, chain, {{"k1", 2}, {"m1", 2}, {"k2", 4}}, 1))));
}

// (k_t + k1 - m0)(k1 + k2 - m1) = k1^2 at omega = 1.
BOOST_AUTO_TEST_CASE(antiresonance_of_a_chain_is_zero) {
  const auto velocity = certified_critical_velocity(
      scene(1, 1, "k1 - (mass(m1) | k2)", {{"k1", 2}, {"m1", 2}, {"k2", 2}}, 1));
  BOOST_TEST(velocity.value == 0);
  BOOST_TEST(velocity.relative_error_bound == 0);
}

// k1 = m1 omega^2: the absorber takes all of the force, the body stands still, K_d is infinite.
BOOST_AUTO_TEST_CASE(a_tuned_absorber_makes_the_drive_rigid) {
  const Scene tuned = scene(2, 4, "kd | k1 - mass(m1)", {{"kd", 0.3}, {"k1", 8}, {"m1", 2}}, 1.7);
  BOOST_TEST(certified(tuned) == 0.5 * 2 * 1 * 3 / 4);
  BOOST_TEST(tuned.warnings.empty());
}

// The node of m1 offers no stiffness of its own, k1 + k2 = m1 omega^2; still
// K_d = k1 + k1^2 (k2 + k3)/k2^2 = 3.
BOOST_AUTO_TEST_CASE(a_vanishing_pivot_is_no_resonance) {
  const Scene s =
      scene(2, 4, "k1 - (mass(m1) | k2 - k3)", {{"k1", 1}, {"k2", 1}, {"k3", 1}, {"m1", 0.5}});
  BOOST_TEST(certified(s) == 0.5 * 2 * 1 * 3 / 4.0 * 7 / 3);
}

// Two absorbers tuned to one frequency: their forces on the standing body are not determined.
BOOST_AUTO_TEST_CASE(absorbers_tuned_alike_are_told) {
  const Scene s = scene(2, 4, "kd | k1 - mass(m1) | k2 - mass(m2)",
                        {{"kd", 1}, {"k1", 8}, {"m1", 2}, {"k2", 4}, {"m2", 1}});
  BOOST_CHECK_THROW(certified_critical_velocity(s), ModelError);
}

// Masses do not move while the drive creeps: c1 - (m1 | c2) has 1/eta = 1/c1 + 1/c2 = 3/2, under
// mu0 k_n u_z0 = 3.
BOOST_AUTO_TEST_CASE(masses_do_not_creep) {
  const Scene s = scene(2, 4, "c1 - (mass(m1) | c2)", {{"c1", 2}, {"m1", 5}, {"c2", 1}});
  BOOST_TEST(std::abs(creep_velocity(s) - 4.5) <= 1e-15 * 4.5 * 4);
  BOOST_TEST(
      creep_velocity(scene(2, 4, "k1 - (mass(m1) | k2)", {{"k1", 2}, {"m1", 5}, {"k2", 1}})) == 0);
}

BOOST_AUTO_TEST_CASE(a_mass_of_value_0_is_left_out) {
  const test::Elements values{{"k1", 2}, {"k2", 1}, {"m1", 0}};
  BOOST_TEST(certified(scene(2, 4, "k1 - (mass(m1) | k2)", values)) ==
             certified(scene(2, 4, "k1 - k2", {{"k1", 2}, {"k2", 1}})));
  BOOST_CHECK(scene(2, 4, "k2 | k1 - mass(m1)", values).drive.value() == spring({"k2"}));
}

BOOST_AUTO_TEST_SUITE_END()
