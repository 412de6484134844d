// Elements over hundreds of decades: what eval says beside v* is right there, too. True values:
// nodal elimination in up to 5000 digits.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
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

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
