// What vibration does to a scene, and how that is said. Numbers by hand, or by Eq. (24) in mpmath.
#include "answers/effect.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "answers/effect_words.hpp"
#include "answers/ringing.hpp"
#include "base/errors.hpp"
#include "record/fields.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_effect)

using namespace vcrit;

namespace {

Problem scene(const std::string& name, const Settings& settings = {}) {
  return read_problem(std::string(VCRIT_SCENES) + "/" + name + ".toml", settings);
}

// A spring on a spring: K_n(0) = |K_n|, so that friction at rest is 1 - du_z/u_z0.
test::SceneText springs() {
  return {.normal = "kn",
          .tangential = "kt",
          .frequency = 1e3,
          .angular_frequency = {},
          .amplitude = 2e-7,
          .indentation = 1e-6,
          .coefficient = 0.5,
          .elements = {{"kn", 1e6}, {"kt", 1e6}}};
}

std::string said(const test::SceneText& text) { return sentence(effect_of(test::scene_of(text))); }

double relative(double found, double expected) { return std::abs(found / expected - 1); }

}  // namespace

// v* = 0.00409484150375441745, the largest closed amplitude 0.39677336269670169 um, 1 - 0.1 um over
// that 0.74796695191345, and the mean force k0 u_z0 = 4 N.
BOOST_AUTO_TEST_CASE(a_closed_contact_has_its_least_friction_at_rest) {
  const Effect effect = effect_of(scene("zener"));
  BOOST_TEST((effect.kind == Effect::Kind::lowers));
  BOOST_TEST(relative(effect.critical_velocity, 0.00409484150375441745) < 1e-15);
  BOOST_TEST(relative(effect.largest_closed_amplitude.value(), 3.96773362696701688e-7) < 1e-14);
  BOOST_TEST(relative(effect.mean_normal_force.value(), 4) < 1e-14);
  BOOST_TEST(relative(effect.lowest.value(), 0.747966951913449900) < 1e-14);
  BOOST_TEST(sentence(effect) == "Vibration lowers friction below 4.095 mm/s, by at most 25 %.");
  BOOST_TEST(operating_point(effect) ==
             "20 kHz, 0.1 µm amplitude, 0.5 µm indentation (4 N mean normal force). The contact "
             "stays closed up to 0.3968 µm.");
  BOOST_TEST(lowest_friction(effect) == "0.748 of the sliding value (at rest)");
  BOOST_TEST(closed_range(effect) == "up to 0.3968 µm (now 0.1 µm)");
  BOOST_TEST(rounding_error(effect) == "below 1.1e-16");
  BOOST_TEST(sentence(effect, all_digits) ==
             "Vibration lowers friction below 4.094841503754418 mm/s, by at most 25 %.");
}

// v* = mu0 omega du_z kn/kt = 0.5 2 pi 1000 2e-7 = 0.000628319.
BOOST_AUTO_TEST_CASE(springs_by_hand) {
  BOOST_TEST(said(springs()) == "Vibration lowers friction below 628.3 µm/s, by at most 20 %.");
  test::SceneText faint = springs();
  faint.amplitude = 3e-9;  // 0.3 % of the indentation
  BOOST_TEST(said(faint) == "Vibration lowers friction below 9.425 µm/s, by at most 0.3 %.");
}

// Of the scene in docs/physics.md: a body swings, and friction is lowest at rest all the same.
BOOST_AUTO_TEST_CASE(of_a_body_friction_is_lowest_at_rest) {
  test::SceneText body = springs();
  body.network = "kd | cd";
  body.mass = 1.4;
  body.frequency = {};
  body.angular_frequency = 1;
  body.amplitude = 0.9;
  body.indentation = 1;
  body.elements = {{"kn", 3}, {"kt", 3}, {"kd", 0.5}, {"cd", 0.02}};
  const Effect effect = effect_of(test::scene_of(body));
  BOOST_TEST(relative(effect.lowest.value(), 0.1) < 1e-12);
}

// k_t + k_d = m (3 omega)^2 without damping: stuck, it swings for ever.
BOOST_AUTO_TEST_CASE(a_body_that_rings_has_no_limit_at_rest) {
  test::SceneText body = springs();
  body.network = "kd";
  body.mass = 1;
  body.frequency = {};
  body.angular_frequency = 1;
  body.amplitude = 0.5;
  body.indentation = 1;
  body.elements = {{"kn", 3}, {"kt", 6.5}, {"kd", 2.5}};
  const Problem problem = test::scene_of(body);
  BOOST_TEST(std::isinf(ringing(simulation::system_of(problem))));
  BOOST_TEST(!effect_of(problem).lowest);
  BOOST_TEST(sentence(effect_of(problem)).ends_with("friction at rest has no known limit."));
  BOOST_TEST(ringing(simulation::system_of(scene("elastic"))) == 1);
}

// Eq. (24) 0.0077401523756, creep mu0 kn u_z0/c1 = 0.15 4/8000 = 75 um/s.
BOOST_AUTO_TEST_CASE(a_path_that_creeps_has_a_drive_speed) {
  const Effect effect = effect_of(scene("burgers"));
  BOOST_TEST(effect.creeps());
  BOOST_TEST(!effect.lowest);
  BOOST_TEST(
      sentence(effect) ==
      "Vibration lowers friction below a drive speed of 7.815 mm/s; 75 µm/s of it is creep.");
  BOOST_TEST(sentence(effect_of(read_scene(VCRIT_SCENES "/burgers.toml", {{"amplitude", "0"}}))) ==
             "Without vibration friction is full above a drive speed of 75 µm/s; below it the path "
             "creeps.");
}

BOOST_AUTO_TEST_CASE(a_contact_that_opens_has_no_friction_at_rest) {
  test::SceneText opening = springs();
  opening.separation = true;
  opening.amplitude = 1.5e-6;
  BOOST_TEST(said(opening) ==
             "Vibration lowers friction below 4.712 mm/s. The contact opens in every cycle, so "
             "friction falls to zero as the speed does.");
  opening.amplitude = 2e-7;  // allowed to open, and does not
  BOOST_TEST(said(opening) == "Vibration lowers friction below 628.3 µm/s, by at most 20 %.");
}

BOOST_AUTO_TEST_CASE(a_simulated_velocity_says_so) {
  const Effect effect = effect_of(test::scene_of(test::slow_zener()));
  BOOST_TEST(effect.simulated);
  BOOST_TEST(sentence(effect).find(
                 " (by simulation: the formula does not apply once the contact opens). The contact "
                 "opens in every cycle") != std::string::npos);
  Effect rough = effect;
  rough.critical_velocity = rough.drive_velocity = rough.reduced_below = 0.0123456;
  rough.relative_error = 1e-3;  // leaves two digits, half a unit of which is 0.4 %
  BOOST_TEST(sentence(rough).starts_with("Vibration lowers friction below 12 mm/s (by"));
  BOOST_TEST(rounding_error(rough) == "about 0.001");
}

// |k + i omega c| = |1.2e6 + i 2 pi 60000 6.366| = 2683.1 N/mm: 1.2/2.6831 0.5 um = 0.2236 um.
BOOST_AUTO_TEST_CASE(outside_the_model_there_is_no_number) {
  const Effect effect = effect_of(scene("inadmissible"));
  BOOST_TEST((effect.kind == Effect::Kind::outside));
  BOOST_TEST(std::isnan(effect.critical_velocity));
  BOOST_TEST(sentence(effect) ==
             "No answer: at this amplitude the contact would open. It stays closed up to 0.2236 µm "
             "(now 0.36 µm). Allow separation or lower the amplitude.");
  test::SceneText fluid = springs();
  fluid.normal = "damper(cn)";
  fluid.elements = {{"cn", 1}, {"kt", 1e6}};
  BOOST_TEST(said(fluid) == "No answer: the normal network carries no static load: K_n(0) = 0.");
}

// K_t + K_d = m omega^2, and K_d = m omega^2, in numbers that are equal in doubles.
BOOST_AUTO_TEST_CASE(resonance_and_antiresonance) {
  test::SceneText body = springs();
  body.frequency = {};
  body.angular_frequency = 1024;
  body.network = "kd";
  body.mass = 1;
  body.elements = {{"kn", 1e6}, {"kt", 524288}, {"kd", 524288}};
  BOOST_TEST(said(body) ==
             "At 163 Hz vibration cannot lower friction: the contact point stands still "
             "(antiresonance).");
  body.elements = {{"kn", 1e6}, {"kt", 524288}, {"kd", 1048576}};
  BOOST_TEST(said(body) ==
             "At 163 Hz vibration lowers friction at every speed (undamped resonance; any damping "
             "makes v* finite).");
}

BOOST_AUTO_TEST_CASE(without_vibration_or_friction_there_is_no_antiresonance) {
  test::SceneText still = springs();
  still.amplitude = 0;
  BOOST_TEST(said(still) == "Without vibration friction is full at every speed.");
  still = springs();
  still.coefficient = 0;
  BOOST_TEST(said(still) == "There is no friction that vibration could lower.");
}

// The limit at rest, 1 - du_z |K_n|/(K_n(0) u_z0) = 1 - 0.2 |K_n|/9 N/um, whatever the drive.
BOOST_AUTO_TEST_CASE(on_a_drive_with_masses_it_is_that_of_the_contact) {
  const std::complex<double> lag(0, 2 * std::numbers::pi * 20e3 * 40 / 5e6);
  const double lowest = 1 - 0.2 * std::abs(9.0 + 5.0 * lag / (1.0 + lag)) / 9;
  const Effect effect = effect_of(scene("sonotrode"));
  BOOST_TEST(std::abs(effect.lowest.value() - lowest) < 1e-14);
}

BOOST_AUTO_TEST_CASE(on_a_measured_drive_it_is_that_of_the_contact) {
  const std::complex<double> normal(12e6, 2 * std::numbers::pi * 20.1e3 * 8);
  const double lowest = 1 - 0.1 * std::abs(normal) / (0.4 * 12e6);
  BOOST_TEST(std::abs(effect_of(scene("measured_drive")).lowest.value() - lowest) < 1e-14);
}

BOOST_AUTO_TEST_CASE(where_nothing_moves_the_reason_is_told) {
  test::SceneText text = springs();
  text.normal = "lossy(kn, eta)";
  text.elements.emplace_back("eta", 0.1);
  const Effect effect = effect_of(test::scene_of(text));
  BOOST_TEST(!effect.lowest);
  BOOST_TEST(lowest_friction(effect).empty());
  BOOST_TEST(sentence(effect).find(". By how much is not computed: lossy(k, eta) is not causal") !=
             std::string::npos);
}

// An elastic punch is one contact: 1 - du_z/u_z0.
BOOST_AUTO_TEST_CASE(below_an_indenter_the_motion_says_it) {
  test::SceneText punch = springs();
  punch.normal = "spring(E)";
  punch.tangential = {};
  punch.poisson = 0;
  punch.indenter = "shape = \"flat\"\nradius = 1e-3\n";
  punch.elements = {{"E", 1e9}};
  const Effect effect = effect_of(test::scene_of(punch));
  BOOST_TEST(std::abs(effect.lowest.value() - 0.8) < 1e-15);
  // 2 a E u_z0 = 2 1e-3 1e9 1e-6
  BOOST_TEST(relative(effect.mean_normal_force.value(), 2) < 1e-15);
  BOOST_TEST(
      operating_point(effect).ends_with("The contact stays closed at its centre up to 1 µm."));
}

// Below a parabola of a Zener half-space the middle, which stays closed, carries least at one
// instant, the rim nothing: E(0) of depth u_z0 - du_z |E|/E(0). On a rigid drive as on a spring.
BOOST_AUTO_TEST_CASE(below_an_indenter_the_limit_at_rest_does_not_ask_for_the_drive) {
  test::SceneText ball{.normal = "spring(E0) | (spring(E1) - damper(c1))",
                       .poisson = 0,
                       .indenter = "shape = \"parabola\"\nradius = 1\n",
                       .angular_frequency = 1,
                       .amplitude = 0.3,
                       .force = 2};
  ball.elements = {{"E0", 1}, {"E1", 0.8}, {"c1", 0.4}};
  const std::complex<double> lag(0, 0.5);
  const double swing = 0.3 * std::abs(1.0 + 0.8 * lag / (1.0 + lag));
  const Effect rigid = effect_of(test::scene_of(ball));
  ball.network = "kd | cd";
  ball.elements.push_back({"kd", 3});
  ball.elements.push_back({"cd", 0.5});
  const Effect held = effect_of(test::scene_of(ball));
  const double depth = rigid.indentation.value() - swing;
  const double least = 4.0 / 3 * std::pow(depth, 1.5) / 2;
  BOOST_TEST(relative(rigid.lowest.value(), least) < 1e-14);
  BOOST_TEST(relative(held.lowest.value(), least) < 1e-14);
}

// Whatever the amplitude is now, also one that lifts the tip off for most of a period: W/(2 a E) of
// an elastic punch. A parabola opens all over at du_z = u_z0, where the mean of (1 + cos t)^(3/2)
// over a period, 8 sqrt(2)/(3 pi), times 4/3 E sqrt(R) u_z0^(3/2) is W. The mean force is a
// quadrature to 1e-12, of which the amplitude is the power 2/3.
BOOST_AUTO_TEST_CASE(under_a_load_the_largest_amplitude_does_not_ask_for_the_present_one) {
  const double mean = 8 * std::numbers::sqrt2 / (3 * std::numbers::pi);
  for (const bool flat : {true, false})
    for (int i = 0; i < 40; ++i) {
      const double load = std::pow(10, -6 + 0.31 * i);
      const double expected = flat ? load / 2 : std::pow(load / (4.0 / 3 * mean), 2.0 / 3);
      for (const double share : {1e-3, 0.9, 2.0, 100.0}) {
        test::SceneText tip{.normal = "spring(E)",
                            .poisson = 0,
                            .indenter = flat ? "shape = \"flat\"\nradius = 1\n"
                                             : "shape = \"parabola\"\nradius = 1\n",
                            .angular_frequency = 1,
                            .amplitude = share * expected,
                            .force = load};
        tip.elements = {{"E", 1}};
        const auto found = largest_closed_amplitude(test::scene_of(tip));
        BOOST_TEST_REQUIRE(found.has_value());
        BOOST_TEST(relative(*found, expected) < 1e-12, load << " " << share << " " << flat);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_record_has_no_words) {
  const record::Json json = record::json_of(effect_of(scene("zener")));
  BOOST_TEST(json.at("kind") == "lowers");
  BOOST_TEST(json.at("lowest_friction").is_number());
  BOOST_TEST(json.at("simulated") == false);
  BOOST_TEST(!record::json_of(effect_of(scene("inadmissible"))).contains("critical_velocity"));
}

BOOST_AUTO_TEST_CASE(checks_that_failed_forbid_the_numbers) {
  BOOST_TEST(failed_checks(2, 9) == "Do not use these numbers: 2 of 9 checks failed.");
}

BOOST_AUTO_TEST_SUITE_END()
