// Errors of evaluators: counted right, the worst found, the wrong ones named, and the compiled ones
// really run.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "accuracy/evaluator_errors.hpp"
#include "accuracy/front.hpp"
#include "derivation/derivation.hpp"
#include "run/driver_source.hpp"
#include "scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(test_accuracy_evaluators)

using namespace vcrit;
using namespace vcrit::validation;
using namespace vcrit::validation::accuracy;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Scene scene_named(const std::string& name) {
  return read_scene(std::string(VCRIT_SCENES) + "/" + name);
}

/// `size` sets of one number, for each of which v* = 1.5 and the condition number is 6.
struct Plain {
  Inputs inputs;
  VelocityReference reference;
  WayAnswers answers{{"hand", "by hand"}, 10, {}};

  explicit Plain(std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) inputs.sets.push_back({static_cast<double>(i)});
    reference.right.assign(size, 1.5);
    reference.condition.assign(size, 6);
    answers.values.assign(size, 1.5);
  }
  EvaluatorError assessed() const { return assess(answers, inputs, reference); }
};

// 1.5 lies where the unit in the last place is 2^-52.
double off_by(double ulps) { return 1.5 + ulps * 0x1p-52; }

}  // namespace

BOOST_AUTO_TEST_CASE(units_in_the_last_place) {
  BOOST_TEST(ulps(1.5, 1.5) == 0);
  BOOST_TEST(ulps(off_by(3), 1.5) == 3);
  BOOST_TEST(ulps(off_by(-3), 1.5) == 3);
  BOOST_TEST(ulps(1 - 0x1p-53, 1) == 0.5);  // doubles lie closer below a power of two
  BOOST_TEST(ulps(0x1p-1074, 0x1p-1073) == 1);
  BOOST_TEST(ulps(infinite, 1) == infinite);
  BOOST_TEST(ulps(infinite, infinite) == 0);
  BOOST_TEST(std::isnan(ulps(not_a_number, 1)));
}

BOOST_AUTO_TEST_CASE(the_histogram_counts_by_powers_of_two) {
  Histogram histogram;
  for (const double error : {0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 1e300, infinite, not_a_number})
    histogram.add(error);
  BOOST_TEST(histogram.counts[0] == 1U);
  BOOST_TEST(histogram.counts[1] == 2U);
  BOOST_TEST(histogram.counts[2] == 1U);
  BOOST_TEST(histogram.counts[3] == 2U);
  BOOST_TEST(histogram.counts[4] == 1U);
  BOOST_TEST(histogram.counts[Histogram::size - 1] == 1U);
  BOOST_TEST(histogram.not_finite == 2U);
}

BOOST_AUTO_TEST_CASE(planted_faults_are_seen) {
  Plain plain(100);
  plain.answers.values[17] = off_by(8);
  plain.answers.values[30] = not_a_number;
  plain.answers.values[64] = 1.5 * (1 + 1e-6);
  const EvaluatorError result = plain.assessed();
  BOOST_TEST(result.histogram.counts[0] == 97U);
  BOOST_TEST(result.histogram.counts[4] == 1U);
  BOOST_TEST(result.histogram.not_finite == 1U);
  BOOST_REQUIRE(result.worst_inputs.size() == 3U);
  BOOST_TEST(result.worst_inputs[0].set[0] == 30);
  BOOST_TEST(result.worst_inputs[1].set[0] == 64);
  BOOST_TEST(result.worst_inputs[2].set[0] == 17);
  BOOST_TEST(result.worst_inputs[2].found == off_by(8));
  BOOST_TEST(result.worst_inputs[2].right == 1.5);
  BOOST_TEST(result.failure.find("1 values are not finite") != std::string::npos);
  BOOST_TEST(result.failure.find("1 values are off by up to 1.0e-06") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(small_errors_are_no_failure_and_give_the_mean_by_hand) {
  Plain plain(4);
  plain.answers.values = {off_by(3), off_by(-4), 1.5, 1.5};
  const EvaluatorError result = plain.assessed();
  BOOST_TEST(result.failure.empty());
  BOOST_TEST(result.worst == 4);
  BOOST_TEST(result.rms == 2.5);  // sqrt((9 + 16)/4), each step exact
}

// 32 2^-53 x 1e12 = 3.6e-3: an error of 1e-3 is the conditioning's, 1e-2 is not.
BOOST_AUTO_TEST_CASE(what_the_condition_number_explains_is_no_failure) {
  Plain plain(1);
  plain.reference.condition[0] = 1e12;
  plain.answers.values[0] = 1.5 * (1 + 1e-3);
  BOOST_TEST(plain.assessed().failure.empty());
  plain.answers.values[0] = 1.5 * (1 + 1e-2);
  BOOST_TEST(!plain.assessed().failure.empty());
}

BOOST_AUTO_TEST_CASE(infinite_where_that_is_right_is_right_and_0_by_0_counts_nowhere) {
  Plain plain(2);
  plain.reference.right = {infinite, not_a_number};
  plain.answers.values = {infinite, 7};
  const EvaluatorError result = plain.assessed();
  BOOST_TEST(result.failure.empty());
  BOOST_TEST(result.worst_inputs.empty());
  BOOST_TEST(result.histogram.not_finite == 0U);
}

// Errors of 7 i modulo 41 units, i = 0 to 39: each of 0 to 40 once, but for that of i = 40, which
// is 280 - 6 x 41 = 34.
BOOST_AUTO_TEST_CASE(the_ten_worst_are_the_worst) {
  Plain plain(40);
  for (std::size_t i = 0; i < 40; ++i)
    plain.answers.values[i] = off_by(static_cast<double>(7 * i % 41));
  const EvaluatorError result = plain.assessed();
  BOOST_REQUIRE(result.worst_inputs.size() == 10U);
  const std::vector<double> expected{40, 39, 38, 37, 36, 35, 33, 32, 31, 30};
  for (std::size_t i = 0; i < 10; ++i) {
    BOOST_TEST(result.worst_inputs[i].error == expected[i]);
    BOOST_TEST(std::fmod(7 * result.worst_inputs[i].set[0], 41) == expected[i]);
  }
}

BOOST_AUTO_TEST_CASE(the_front_by_hand) {
  //  cost    1    2    3    4    4
  //  error   5    5    2    3    1     (2, 5) loses to (1, 5), (4, 3) to (3, 2)
  const std::vector<bool> front = on_front({{1, 5}, {2, 5}, {3, 2}, {4, 3}, {4, 1}});
  BOOST_TEST((front == std::vector<bool>{true, false, true, false, true}));
  BOOST_TEST((on_front({{1, 1}, {1, 1}}) == std::vector<bool>{true, true}));
}

BOOST_AUTO_TEST_CASE(a_failed_way_is_not_ranked) {
  std::vector<EvaluatorError> ways(2);
  for (EvaluatorError& way : ways) way.nanoseconds = way.worst = 2;
  ways[0].worst = 1;
  ways[0].failure = "wrong";
  mark_front(ways);
  BOOST_TEST(!ways[0].on_front);
  BOOST_TEST(ways[1].on_front);
}

// Every way on a real scene, compiled. The accurate grade promises one unit in the last place, and
// the reference is rounded once; the others have 32 roundings times the condition number.
BOOST_AUTO_TEST_CASE(all_ways_of_the_zener_scene_run_and_are_right) {
  const Scene scene = scene_named("zener.toml");
  const auto compiler = find_compiler();
  BOOST_REQUIRE(compiler.has_value());
  const Driver driver(symbolic::derive(scene), *compiler);
  BOOST_TEST(driver.missing().empty());
  const Inputs inputs = draw_inputs(scene, driver.symbols(), 64, 1);
  const EvaluatorErrors errors = evaluator_errors(scene, &driver, inputs);
  BOOST_TEST(errors.ways.size() == 10U);
  for (const EvaluatorError& way : errors.ways) {
    BOOST_TEST_CONTEXT(way.name) {
      BOOST_TEST(way.failure == "");
      BOOST_TEST(way.measured);
      BOOST_TEST(way.nanoseconds > 0);
      if (way.key.starts_with("accurate") || way.key == "certified") BOOST_TEST(way.worst <= 1);
    }
  }
}

// A contact that opens with a memory has no evaluator; a drive with masses has each.
BOOST_AUTO_TEST_CASE(what_a_scene_does_not_have_is_missing_with_its_reason) {
  const Scene opening = read_scene(VCRIT_TEST_DATA "/../matrix/kinds/separation_masses.toml");
  const Driver driver(symbolic::derive(opening), *find_compiler());
  BOOST_TEST(!driver.has("fast"));
  BOOST_TEST(driver.has("complex"));
  BOOST_REQUIRE(driver.missing().size() == 7U);
  BOOST_TEST(driver.missing()[0].reason.starts_with("no closed form of v*"));
  const Driver masses(symbolic::derive(scene_named("sonotrode.toml")), *find_compiler());
  BOOST_TEST(masses.has("fast"));
  BOOST_REQUIRE(masses.missing().size() == 1U);
  BOOST_TEST(masses.missing()[0].reason == "it stays nested: the same as Eq. 24 as written");
}

BOOST_AUTO_TEST_CASE(a_massless_rigid_scene_has_no_mass_and_no_drive_in_its_driver) {
  const Scene scene = scene_named("elastic.toml");
  const symbolic::Derivation formula = symbolic::derive(scene);
  const std::string source = driver_source(formula, true);
  BOOST_TEST(source.find("p.kt") != std::string::npos);
  for (const char* word : {"p.m)", "p.m ", "p.m*", "K_d", "kd", "mass", "drive"})
    BOOST_TEST(source.find(word) == std::string::npos, word);
}

BOOST_AUTO_TEST_SUITE_END()
