// Parameter sets around a scene: the same always, where they are said to be, and close to
// resonance.
#include "accuracy/inputs.hpp"
#include "scene/scene.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(test_accuracy_inputs)

using namespace vcrit;
using namespace vcrit::validation::accuracy;

namespace {

constexpr std::uint64_t seed = 42;

Scene scene_named(const std::string& name) {
  return read_scene(std::string(VCRIT_SCENES) + "/" + name);
}

const std::vector<Symbol> all{{"mu0"}, {"omega"}, {"du_z"}, {"m"}, {"kn"}, {"kt"}, {"kd"}};

}  // namespace

BOOST_AUTO_TEST_CASE(sets_are_the_same_in_every_run_and_others_with_another_seed) {
  const Scene scene = scene_named("elastic_drive.toml");
  BOOST_TEST((draw_inputs(scene, all, 50, seed).sets == draw_inputs(scene, all, 50, seed).sets));
  BOOST_TEST((draw_inputs(scene, all, 50, seed).sets != draw_inputs(scene, all, 50, 43).sets));
}

// The engine's numbers are fixed by the C++ standard; the rest is the definition, computed again.
BOOST_AUTO_TEST_CASE(a_number_is_log_uniform_in_the_decade_around_its_value) {
  const Scene scene = scene_named("elastic.toml");
  const std::vector<Symbol> symbols{{"kt"}, {"omega"}};
  const Inputs inputs = draw_inputs(scene, symbols, 1, seed);
  std::mt19937_64 engine(seed);
  const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
  // One rounding of pow (below 2 ulp in glibc) and one of the product.
  BOOST_TEST(std::abs(inputs.sets[0][0] / (9.47e6 * std::pow(10, share - 0.5)) - 1) < 4 * 0x1p-52);
}

// Each value lies within half a decade, but for rounding; in 1000 draws each tenth of the decade
// is hit (chance of missing one: 10 (9/10)^1000 = 2e-45).
BOOST_AUTO_TEST_CASE(the_decade_is_filled) {
  const Inputs inputs = draw_inputs(scene_named("elastic.toml"), {{"omega"}, {"kt"}}, 1000, seed);
  std::vector<int> tenths(10);
  for (const auto& set : inputs.sets) {
    const double place = std::log10(set[1] / 9.47e6) + 0.5;
    BOOST_TEST(std::abs(place - 0.5) <= 0.5 + 1e-15);
    ++tenths[static_cast<std::size_t>(std::min(9.0, std::max(0.0, 10 * place)))];
  }
  for (const int count : tenths) BOOST_TEST(count > 0);
}

// An elastic scene's resonance is sqrt(kd/m), its antiresonance sqrt((kt + kd)/m). The place is
// found to some 2^-50, and the offset is at least 1e-12.
BOOST_AUTO_TEST_CASE(every_fourth_set_is_near_resonance_and_every_fourth_near_antiresonance) {
  const Inputs inputs = draw_inputs(scene_named("elastic_drive.toml"), all, 200, seed);
  BOOST_TEST(inputs.near_resonance == 50U);
  BOOST_TEST(inputs.near_antiresonance == 50U);
  double nearest = 1;
  for (std::size_t i = 0; i < inputs.sets.size(); ++i) {
    const auto& set = inputs.sets[i];
    const double stiffness = i % 4 == 0 ? set[6] : i % 4 == 1 ? set[5] + set[6] : 0;
    if (stiffness == 0) continue;
    const double offset = std::abs(set[1] / std::sqrt(stiffness / set[3]) - 1);
    BOOST_TEST(offset <= 1e-2 * (1 + 1e-9));
    BOOST_TEST(offset >= 1e-12 * (1 - 1e-2));
    nearest = std::min(nearest, offset);
  }
  // 100 offsets over ten decades: none below 1e-8 has a chance of (6/10)^100.
  BOOST_TEST(nearest < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_massless_scene_has_no_resonance) {
  const Inputs inputs = draw_inputs(scene_named("elastic.toml"), {{"omega"}}, 20, seed);
  BOOST_TEST(inputs.near_resonance + inputs.near_antiresonance == 0U);
}

BOOST_AUTO_TEST_CASE(in_a_measured_drive_omega_stays_in_the_table) {
  const Scene scene = scene_named("measured_drive.toml");
  const Inputs inputs = draw_inputs(scene, {{"omega"}}, 200, seed);
  for (const auto& set : inputs.sets) {
    BOOST_TEST(set[0] >= scene.receptance->rows.front().omega);
    BOOST_TEST(set[0] <= scene.receptance->rows.back().omega);
  }
}

BOOST_AUTO_TEST_SUITE_END()
