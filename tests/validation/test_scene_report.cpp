// What passes, what fails, and what counts as neither.
#include "compare/scene_report.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_scene_report)

using namespace vcrit::validation;
using Outcome = Comparison::Outcome;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Comparison pair(double expected, double found, double tolerance) {
  Comparison comparison;
  comparison.expected = expected;
  comparison.found = found;
  comparison.tolerance = tolerance;
  return comparison;
}

}  // namespace

BOOST_AUTO_TEST_CASE(differences_are_relative_or_absolute) {
  Comparison comparison = pair(4, 5, 0);  // all numbers here are exact in binary
  BOOST_TEST(difference(comparison) == 0.25);
  comparison.measure = Comparison::Measure::absolute;
  BOOST_TEST(difference(comparison) == 1.0);
}

BOOST_AUTO_TEST_CASE(the_tolerance_decides) {
  BOOST_TEST((outcome(pair(4, 5, 0.25)) == Outcome::passed));
  BOOST_TEST((outcome(pair(4, 5, 0.24)) == Outcome::failed));
  BOOST_TEST((outcome(pair(0, 0, 0)) == Outcome::passed));
}

BOOST_AUTO_TEST_CASE(what_is_no_number_fails_whatever_the_tolerance) {
  BOOST_TEST((outcome(pair(1, not_a_number, infinity)) == Outcome::failed));
  BOOST_TEST((outcome(pair(not_a_number, 1, infinity)) == Outcome::failed));
  BOOST_TEST((outcome(pair(1, infinity, infinity)) == Outcome::failed));
  BOOST_TEST((outcome(pair(infinity, 1, infinity)) == Outcome::failed));
  BOOST_TEST((outcome(pair(0, 1, infinity)) == Outcome::failed));
  BOOST_TEST((outcome(pair(1, 1, not_a_number)) == Outcome::failed));
  BOOST_TEST((outcome(pair(infinity, infinity, 1e-9)) == Outcome::passed));
}

BOOST_AUTO_TEST_CASE(broken_is_failed_and_not_run_is_neither) {
  Comparison comparison = pair(1, 1, 1);
  comparison.broken = true;
  BOOST_TEST((outcome(comparison) == Outcome::failed));
  comparison.broken = false;
  comparison.not_run = true;
  BOOST_TEST((outcome(comparison) == Outcome::not_run));
}

BOOST_AUTO_TEST_CASE(one_perturbed_value_turns_a_scene) {
  SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(passed(report));
  report.comparisons[1].found *= 1 + 2e-9;  // its tolerance is 1e-9
  BOOST_TEST(!passed(report));
  BOOST_TEST(count(report, Outcome::failed) == 1u);
  BOOST_TEST(count(report, Outcome::passed) == 1u);
  BOOST_TEST(tightest(report) == &report.comparisons[1]);
}

BOOST_AUTO_TEST_CASE(the_tightest_is_one_that_was_run) {
  SceneReport report = example::scene_report(example::rigid_scene);
  for (Comparison& comparison : report.comparisons) comparison.not_run = true;
  BOOST_TEST((tightest(report) == nullptr));
  BOOST_TEST(passed(report));
  BOOST_TEST(count(report, Outcome::not_run) == 2u);
  report.comparisons.clear();
  BOOST_TEST((tightest(report) == nullptr));
}

BOOST_AUTO_TEST_SUITE_END()
