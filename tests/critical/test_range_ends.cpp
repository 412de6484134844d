// Elements over hundreds of decades: what eval says beside v* is right there, too. True values:
// nodal elimination in up to 5000 digits.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "simulation/steady/exact.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_range_ends)

namespace {

using namespace vcrit;

Scene scene_of(const std::string& name) {
  return read_scene(VCRIT_TEST_DATA "/range_ends/" + name + ".toml");
}

BOOST_AUTO_TEST_CASE(admissible_where_forces_leave_the_range_of_doubles) {
  for (const char* name : {"admissible_overflow", "admissible_underflow", "drive_velocity_nan"}) {
    Scene scene = scene_of(name);
    BOOST_TEST(inadmissible_reasons(scene).empty(), name);
    scene.amplitude.value = 2 * *scene.indentation.value;
    BOOST_TEST(!inadmissible_reasons(scene).empty(), name);
  }
}

BOOST_AUTO_TEST_CASE(creep) {
  // c2 = 1e-310 is a subnormal double, of which the last place is 5e-14.
  const CriticalOnset tiny = critical_onset(scene_of("drive_velocity_nan"));
  BOOST_TEST(std::abs(tiny.drive_velocity / 9e-41 - 1) <= 3e-14);
  const CriticalOnset graph = critical_onset(scene_of("graph_drive_velocity"));
  // v* is rounded, the creep to some 60 roundings of a long double, the sum once.
  BOOST_TEST(std::abs(graph.drive_velocity / 66703874930324.594 - 1) <= 4e-16);
}

BOOST_AUTO_TEST_CASE(graphs_whose_relaxation_times_are_not_asked_for) {
  BOOST_CHECK_NO_THROW(inadmissible_reasons(scene_of("graph_bug_70")));
  BOOST_TEST(critical_onset(scene_of("graph_bug_70")).contact_velocity > 0);
}

// K_d - m omega^2 is a question of the drive alone: 2200 bits for each step of 3000 branches would
// take hours.
BOOST_AUTO_TEST_CASE(exact_resonance_below_a_large_contact) {
  const auto scene = [](double mass, double coefficient) {
    std::vector<double> stiffnesses, times;
    for (int i = 0; i < 3000; ++i) {
      stiffnesses.push_back(1 + i % 7);
      times.push_back((1 + i) * 1e-4);
    }
    return test::scene_of({.normal = "prony(k0, k, tau, 3000)",
                           .network = "kd",
                           .mass = mass,
                           .coefficient = coefficient,
                           .elements = {{"kd", 8}, {"k0", 1}, {"k", stiffnesses}, {"tau", times}}});
  };
  const CertifiedVelocity at = certified_critical_velocity(scene(2, 0.5));
  BOOST_TEST(std::isinf(at.value));
  BOOST_TEST(at.reason.find("resonance") != std::string::npos);
  BOOST_CHECK_THROW(certified_critical_velocity(scene(2, 0)), ModelError);
  BOOST_TEST(certified_critical_velocity(scene(1, 0)).value == 0);
  BOOST_TEST(std::isfinite(certified_critical_velocity(scene(2.000001, 0.5)).value));
}

// Of random scenes over 600 decades these ended as a bug, with a crash and with NaN for friction: a
// number of the motion without dimensions is no double.
BOOST_AUTO_TEST_CASE(friction_where_numbers_of_the_motion_leave_the_range_of_doubles) {
  using Numbers = std::vector<double>;
  const std::vector<Scene> scenes{
      test::scene_of({.normal = "k0 | (k1 - c1)",
                      .tangential_ratio = 0.75,
                      .network = "kd | cd",
                      .mass = 6.748e-285,
                      .angular_frequency = 2.794e-194,
                      .amplitude = 3.497e40,
                      .indentation = 3.497003497003497e40,
                      .coefficient = 0.04,
                      .elements = {{"k0", 5.544e-81},
                                   {"k1", 3.904e155},
                                   {"c1", 7.62e11},
                                   {"kd", 7.214e-286},
                                   {"cd", 8.653e249}}}),
      test::scene_of({.normal = "prony(k0, k, tau)",
                      .tangential_ratio = 0.75,
                      .network = "kd | cd",
                      .mass = 7.8e191,
                      .angular_frequency = 6.847e293,
                      .amplitude = 4.676e-268,
                      .indentation = 9.352e-268,
                      .coefficient = 8.368e259,
                      .elements = {{"k0", 7.846e94},
                                   {"k", Numbers{6.511e-172, 7.615e-165}},
                                   {"tau", Numbers{3.294e-124, 8.162e184}},
                                   {"kd", 5.66e-135},
                                   {"cd", 7.019e300}}}),
      test::scene_of({.normal = "k0 | (k1 - c1)",
                      .tangential_ratio = 0.75,
                      .network = "kd | cd",
                      .mass = 3.316e79,
                      .angular_frequency = 3.669e200,
                      .amplitude = 6.663e-29,
                      .indentation = 6.523069332566167e284,
                      .coefficient = 4.808e-12,
                      .elements = {{"k0", 6.952e-37},
                                   {"k1", 3.403e276},
                                   {"c1", 5.203e107},
                                   {"kd", 7.357e122},
                                   {"cd", 8.19e-173}}})};
  for (const Scene& scene : scenes) {
    const double v = certified_critical_velocity(scene).value;
    BOOST_TEST((v > 0 && std::isfinite(v)));
    BOOST_TEST(test::refused<ModelError>(
        [&] { simulation::steady_state(simulation::system_of(scene), 0.3 * v); },
        "numbers of this motion leave the range of doubles"));
  }
}

// A mean force of inf or 0 N, a branch of nan N/m: refused as if an option of that name were wrong.
BOOST_AUTO_TEST_CASE(a_system_beyond_doubles_is_outside_the_model) {
  for (const char* name : {"admissible_overflow", "admissible_underflow", "drive_velocity_nan"})
    BOOST_TEST(test::refused<ModelError>(
        [&] { simulation::system_of(scene_of(name)); },
        "in SI units the numbers of this motion leave the range of doubles"));
}

// It was called sliding at half of v*, with a friction ratio of 0.999998 and an error of 0.5.
BOOST_AUTO_TEST_CASE(a_stick_that_rounding_hides) {
  const Scene scene = scene_of("stick_lost");
  const double v = certified_critical_velocity(scene).value;
  BOOST_TEST(test::refused<ModelError>(
      [&] { simulation::steady_state(simulation::system_of(scene), v / 2); },
      "so rounding hides what it does"));
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
