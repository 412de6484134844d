// Contacts that open below a mount without mass: they are those that the vibrator presses through
// mount and contact in series, with the path along the surface as it was.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "answers/under_load.hpp"
#include "base/errors.hpp"
#include "normal/mean_indentation.hpp"
#include "rules/rulebook.hpp"
#include "simulation/system/system.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_opening_mount)

using namespace vcrit;

namespace {

double log_uniform(std::mt19937& random, double from, double to) {
  std::uniform_real_distribution<double> exponent(std::log(from), std::log(to));
  return std::exp(exponent(random));
}

struct Machine {
  std::string mount = "km | cm", contact = "kn | cn", path = "kt | ct", drive = "kd | cd";
  test::Elements elements;
  double amplitude = 1, force = 1, km = 2;  // km: K_m(0)

  test::SceneText text(const std::string& normal, const test::Toml& mount_path = {}) const {
    return {.normal = normal,
            .tangential = path,
            .separation = true,
            .network = drive.empty() ? test::Toml{} : test::Toml{drive},
            .mount = mount_path,
            .angular_frequency = 1.3,
            .amplitude = amplitude,
            .force = force,
            .coefficient = 0.4,
            .elements = elements};
  }
  Problem mounted() const { return test::scene_of(text(contact, mount)); }
  Problem in_series() const { return test::scene_of(text("(" + mount + ") - (" + contact + ")")); }
};

// Opens: the force of the springs alone would swing by some two loads.
Machine random_machine(std::mt19937& random) {
  Machine machine;
  const auto element = [&](const char* name, double middle) {
    const double value = log_uniform(random, middle / 3, middle * 3);
    machine.elements.emplace_back(name, value);
    return value;
  };
  machine.km = element("km", 2);
  const double kn = element("kn", 2);
  element("cm", 0.4), element("cn", 0.4), element("kt", 1), element("ct", 0.3);
  element("kd", 1), element("cd", 0.3);
  if (random() % 2 == 0) {
    machine.mount = "zener(km, k1, cm)";
    element("k1", 1);
  }
  machine.amplitude = log_uniform(random, 0.5, 3);
  machine.force =
      machine.amplitude * log_uniform(random, 0.1, 0.6) * machine.km * kn / (machine.km + kn);
  return machine;
}

}  // namespace

// The same numbers but for the roundings of two forms of one series network, some ten of them, and
// for the Newton step that ends at 1e-10 of the depth, after which the next would be 1e-20: 1e-11
// in friction, whose slope over the depth is at most some ten.
BOOST_AUTO_TEST_CASE(motion_is_that_of_mount_and_contact_in_series) {
  std::mt19937 random(44);
  int with_another = 0;
  for (int i = 0; i < 30; ++i) {
    const Machine machine = random_machine(random);
    const Problem mounted = machine.mounted(), in_series = machine.in_series();
    BOOST_REQUIRE(simulation::system_of(mounted).opening.has_value());
    const CriticalOnset one = critical_onset(mounted), other = critical_onset(in_series);
    BOOST_TEST((one.by == CriticalOnset::By::simulation));
    BOOST_TEST(one.contact_velocity == other.contact_velocity, boost::test_tools::tolerance(1e-10));
    for (const double ratio : {0.2, 0.7}) {
      const double velocity = ratio * other.drive_velocity;
      BOOST_TEST(std::abs(SteadyFriction(mounted).at(velocity).friction_ratio -
                          SteadyFriction(in_series).at(velocity).friction_ratio) < 1e-11);
    }
    // The mount's own deflection lies between the vibrator's place and the body's.
    const double depth = simulation::mean_indentation(mounted);
    BOOST_TEST(std::abs(depth + machine.force / machine.km -
                        simulation::mean_indentation(in_series)) < 1e-11 * machine.amplitude);
    with_another +=
        std::abs(
            one.contact_velocity /
                critical_onset(test::scene_of(machine.text(machine.contact))).contact_velocity -
            1) > 0.01;
    BOOST_TEST(!below_mount(mounted).has_value());
    BOOST_TEST(under_load(mounted)->mean_normal_force == machine.force);
  }
  BOOST_TEST(with_another > 25);  // a test that would pass without the mount shows nothing
}

// Springs alone: <F_n> = k [sqrt(U^2 - u^2) + u acos(-u/U)]/pi at the vibrator's place u, k of both
// springs. v* is Eq. (24) as long as the contact is closed where the vibrator moves fastest, u > 0.
BOOST_AUTO_TEST_CASE(springs_have_a_closed_form) {
  Machine machine{.mount = "km",
                  .contact = "kn",
                  .path = "kt",
                  .drive = "kd",
                  .elements = {{"km", 2}, {"kn", 3}, {"kt", 1}, {"kd", 4}},
                  .amplitude = 0.1};
  const double k = 2 * 3.0 / (2 + 3), U = machine.amplitude;
  for (const double share : {0.4, -0.3}) {
    const double u = share * U;
    machine.force = k * (std::sqrt(U * U - u * u) + u * std::acos(-u / U)) / std::numbers::pi;
    const Problem problem = machine.mounted();
    BOOST_TEST(simulation::mean_indentation(problem) == u - machine.force / 2,
               boost::test_tools::tolerance(1e-10));
    const CriticalOnset onset = critical_onset(problem);
    const double fastest = 0.4 * 1.3 * U * k * (1 + 1 / 4.0);
    if (share > 0) {
      BOOST_TEST((onset.by == CriticalOnset::By::formula));
      BOOST_TEST(onset.contact_velocity == fastest, boost::test_tools::tolerance(1e-15));
    } else {
      // It first touches, at the place 0, where the rate is sqrt(1 - (u/U)^2) of the fastest.
      BOOST_TEST((onset.by == CriticalOnset::By::simulation));
      BOOST_TEST(onset.contact_velocity == fastest * std::sqrt(1 - share * share),
                 boost::test_tools::tolerance(1e-9));
    }
  }
}

// A closed contact is as without `separation`: Eq. (24) and what the mount leaves.
BOOST_AUTO_TEST_CASE(a_contact_that_may_open_and_does_not_is_closed) {
  std::mt19937 random(5);
  Machine machine = random_machine(random);
  machine.force *= 100;
  test::SceneText closed = machine.text(machine.contact, machine.mount);
  closed.separation = {};
  const Problem one = machine.mounted(), other = test::scene_of(closed);
  const CriticalOnset onset = critical_onset(one);
  BOOST_TEST((onset.by == CriticalOnset::By::formula));
  BOOST_TEST(onset.contact_velocity == critical_onset(other).contact_velocity);
  BOOST_TEST(below_mount(one)->amplitude == below_mount(other)->amplitude);
  BOOST_TEST(under_load(one)->indentation.value() == under_load(other)->indentation.value());
  const double velocity = onset.contact_velocity / 2;
  BOOST_TEST(SteadyFriction(one).at(velocity).friction_ratio ==
             SteadyFriction(other).at(velocity).friction_ratio);
}

// K_m -> infinity: the contact that opens under a prescribed height, to the ratio of stiffnesses.
BOOST_AUTO_TEST_CASE(a_stiff_mount_is_none) {
  std::mt19937 random(8);
  Machine machine = random_machine(random);
  machine.mount = "k9";
  machine.elements.emplace_back("k9", 1e9);
  machine.force *= 2;
  const Problem without = test::scene_of(machine.text(machine.contact));
  BOOST_TEST(critical_onset(machine.mounted()).contact_velocity ==
                 critical_onset(without).contact_velocity,
             boost::test_tools::tolerance(1e-7));
  BOOST_TEST(
      simulation::mean_indentation(machine.mounted()) == simulation::mean_indentation(without),
      boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(without_a_load_or_with_a_mass_it_is_refused) {
  const auto said = [](const test::Toml& force, const test::Toml& mass = {}) {
    test::SceneText text{.separation = true,
                         .mount = "km",
                         .mount_mass = mass,
                         .force = force,
                         .elements = {{"kn", 1}, {"km", 1}}};
    return test::refusal<ModelError>(
        [&] { rules::require(rules::Question::motion, test::scene_of(text)); });
  };
  BOOST_TEST(said(1) == "accepted");
  BOOST_TEST(test::has(said({}), "needs a load for its mean force, and none is given"));
  BOOST_TEST(test::has(said(1, 1), "react on each other"));
}

BOOST_AUTO_TEST_SUITE_END()
