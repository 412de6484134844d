// Eq. 24 correctly rounded, against references made elsewhere and against nodal analysis.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <span>
#include <sstream>
#include <vector>

#include "critical/batch.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "problem/variants.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"
#include "support/reference_scene.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_certified)

using namespace vcrit;

BOOST_AUTO_TEST_CASE(every_reference_row_is_correct_to_the_last_bit) {
  int compared = 0, no_scene = 0;
  for (const test::ReferenceRow& row : test::extreme_rows()) {
    if (!row.scene) {
      ++no_scene;
      continue;
    }
    BOOST_TEST_CONTEXT("row " << row.id << " " << row.network_class << " " << row.kind) {
      const CertifiedVelocity velocity = certified_critical_velocity(*row.scene);
      const double expected =
          row.status == "pole" ? std::numeric_limits<double>::infinity() : row.velocity;
      BOOST_TEST(velocity.value == expected);
      BOOST_TEST(std::isinf(expected) == !velocity.reason.empty());
      ++compared;
    }
  }
  BOOST_TEST(compared + no_scene == 247);
  BOOST_TEST(no_scene == 5);  // rows whose elements are all 0 in one network
}

// 3/4 of the double 0.4, exactly half-way between 0.3 and the double above it, in whole numbers.
BOOST_AUTO_TEST_CASE(half_way_between_two_doubles_is_one_of_them) {
  const CertifiedVelocity velocity = certified_critical_velocity(
      test::scene_of({.normal = "kn",
                      .tangential = "kt",
                      .network = "kd | cd",
                      .mass = 2,
                      .angular_frequency = 1,
                      .amplitude = 0.4,
                      .coefficient = 0.5,
                      .elements = {{"kn", 3}, {"kt", 2}, {"kd", 1}, {"cd", 0.5}}}));
  BOOST_TEST((velocity.value == 0.3 || velocity.value == std::nextafter(0.3, 1)));
  BOOST_TEST(velocity.relative_error_bound <= 0x1p-53);
}

// v* of the decimals that are typed, by Eq. (24) with mpmath at 60 digits. At resonance the double
// of 2 pi f, or of "5 g", makes another v* in the fifth digit.
BOOST_AUTO_TEST_CASE(what_is_typed_is_carried_exactly) {
  const auto at = [](const char* frequency) {
    return certified_critical_velocity(
               read_scene(VCRIT_SCENES "/zener.toml", {{"frequency", frequency}}))
        .value;
  };
  BOOST_TEST(at("3183.098865021006 Hz") == 1216391.5523782628222);
  BOOST_TEST(at("3183.09886184109 Hz") == 1216320731.5228099629);
  // A bare number is a double, of which 2 pi f is exact, too, also where it is swept.
  BOOST_TEST(at("3183.09886184109") == 1216250587.0457556457);
  const std::vector<double> frequency{3183.09886184109};
  const std::vector<std::span<const double>> columns{frequency};
  double swept = 0;
  CriticalVelocities(read_scene(VCRIT_SCENES "/zener.toml"), {"frequency"}, Grade::certified)(
      columns, {&swept, 1});
  BOOST_TEST(swept == 1216250587.0457556457);
  BOOST_TEST(at("3.18309886184109 kHz") == 1216320731.5228099629);
  const auto of_amplitude = [](const char* amplitude) {
    return certified_critical_velocity(
               read_scene(VCRIT_SCENES "/zener.toml", {{"amplitude", amplitude}}))
        .value;
  };
  BOOST_TEST(of_amplitude("0.1 um") == of_amplitude("100 nm"));
  // K_d = m omega^2 in the decimals, not in their doubles.
  const Scene resonant =
      read_scene(VCRIT_SCENES "/zener.toml", {{"angular_frequency", "20000 rad/s"}});
  BOOST_TEST(std::isinf(certified_critical_velocity(resonant).value));
  BOOST_TEST(std::isfinite(certified_critical_velocity(as_doubles(resonant)).value));
  // What is changed after reading is what it was changed to.
  Scene changed = read_scene(VCRIT_SCENES "/zener.toml");
  changed.amplitude.value = 2 * *changed.amplitude.value;
  const double twice = certified_critical_velocity(as_doubles(changed)).value;
  BOOST_TEST(std::abs(certified_critical_velocity(changed).value / twice - 1) < 1e-15);
}

BOOST_AUTO_TEST_CASE(random_scenes_round_like_nodal_analysis_at_250_digits) {
  test::RandomScenes random(20, 6);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random.scene(12);
    const CertifiedVelocity velocity = certified_critical_velocity(scene);
    const test::Real expected = test::critical_velocity_by_nodes(scene);
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(velocity.value == static_cast<double>(expected));
      BOOST_TEST(velocity.relative_error_bound == std::numeric_limits<double>::epsilon() / 2);
    }
  }
}

// Series-parallel doubles lose at most 2 C u, C below 10 an element (docs/physics.md), and the sums
// with the inertia up to their own cancellation; 12 elements a network are well inside 2e-14 where
// neither sum cancels to below a tenth.
BOOST_AUTO_TEST_CASE(doubles_agree_away_from_resonance) {
  test::RandomScenes random(21, 4);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Scene scene = random.scene(12);
    if (scene.mass) continue;
    const double expected = certified_critical_velocity(scene).value;
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(std::abs(critical_velocity(scene) - expected) <= 2e-14 * expected);
    }
    ++compared;
  }
  BOOST_TEST(compared > 200);
}

namespace {

Scene undamped_drive(double mass) {
  return test::scene_of({.tangential = "kt",
                         .network = "kd",
                         .mass = mass,
                         .elements = {{"kn", 3}, {"kt", 4}, {"kd", 8}}});
}

}  // namespace

BOOST_AUTO_TEST_CASE(resonance_is_infinite_with_its_reason) {
  const CertifiedVelocity velocity = certified_critical_velocity(undamped_drive(2));  // 8 - 2 * 2^2
  BOOST_TEST(std::isinf(velocity.value));
  BOOST_TEST(velocity.reason.find("resonance") != std::string::npos);
}

// p/(1 + p) + q/(1 + q) is 1 where p q = 1, and q here has the dual branches of p: the innermost
// element is the spring x of p and y = 1/x of q. Twice the y changes K_d by 2^-15000 of itself, so
// that v* is no double but finite. (By whole numbers.)
BOOST_AUTO_TEST_CASE(a_drive_of_many_springs_is_resonant_only_where_it_is_exactly) {
  const auto at = [](double y) {
    constexpr double large = 0x1p1000, small = 0x1p-1000;
    const Scene scene =
        test::scene_of({.tangential = "kt",
                        .network = "k1 - (k2 | k3 - (k4 | k5 - (k6 | k7 - (k8 | k9 - kx))))"
                                   " | k1 - (k2 - (k4 | k3 - (k6 | k5 - (k8 | k7 - (kl | ky)))))",
                        .mass = 1,
                        .angular_frequency = 1,
                        .elements = {{"kn", 3},
                                     {"kt", 4},
                                     {"k1", 1},
                                     {"k2", 1},
                                     {"k3", small},
                                     {"k4", large},
                                     {"k5", small},
                                     {"k6", large},
                                     {"k7", small},
                                     {"k8", large},
                                     {"k9", small},
                                     {"kx", large},
                                     {"kl", large},
                                     {"ky", y}}});
    return certified_critical_velocity(scene);
  };
  const CertifiedVelocity resonant = at(0x1p-1000), near = at(0x1p-999);
  BOOST_TEST((std::isinf(resonant.value) && resonant.relative_error_bound == 0));
  BOOST_TEST(resonant.reason == "resonance: K_d = m omega^2, so that v* is infinite");
  BOOST_TEST((std::isinf(near.value) && std::isinf(near.relative_error_bound)));
  BOOST_TEST(near.reason == "v* is above the largest double");
}

BOOST_AUTO_TEST_CASE(antiresonance_is_zero) {
  const CertifiedVelocity velocity =
      certified_critical_velocity(undamped_drive(3));  // 4 + 8 - 3 * 2^2
  BOOST_TEST(velocity.value == 0);
  BOOST_TEST(velocity.relative_error_bound == 0);
}

BOOST_AUTO_TEST_CASE(zero_by_zero_is_outside_the_model) {
  Scene scene = undamped_drive(2);
  scene.coefficient.value = 0.0;
  BOOST_CHECK_THROW(certified_critical_velocity(scene), ModelError);
}

BOOST_AUTO_TEST_SUITE_END()
