// The friction curve's rules, and the closed form of the elastic contact.
#include "compare/friction.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_friction)

using namespace vcrit::validation;
using Outcome = Comparison::Outcome;

namespace {

std::vector<ComparedPoint> curve() {
  std::vector<ComparedPoint> points;
  for (const double ratio : {0.25, 0.5, 0.75, 1.1, 1.2})
    points.push_back(example::curve_point(ratio, 1.0));
  return points;
}

}  // namespace

// G(vbar) from 30-digit arithmetic (docs/physics.md); friction is 1 - D G. The terms of G are below
// 2 pi and divided by 2 pi, with fewer than ten roundings, and G does not change to first order
// with the end of stick: 10 x 2^-53 = 1.1e-15.
BOOST_AUTO_TEST_CASE(the_closed_form_has_its_published_values) {
  struct Row {
    double ratio, g;
  };
  for (const Row& row : {Row{0.001, 0.99693266303416232517}, Row{0.1, 0.75717136015312994339},
                         Row{0.25, 0.4918816026829403061}, Row{0.5, 0.2014522033336686888},
                         Row{0.75, 0.047238266278833194827}, Row{0.9, 0.0073108103345282100357},
                         Row{0.99, 0.000071763498506863749421}})
    for (const double amplitude : {0.3, 1.0})
      BOOST_TEST(std::abs(elastic_friction(amplitude, row.ratio) - (1 - amplitude * row.g)) <
                 1.1e-15);
}

BOOST_AUTO_TEST_CASE(full_friction_from_the_critical_velocity_on) {
  BOOST_TEST(elastic_friction(0.7, 1) == 1);
  BOOST_TEST(elastic_friction(0.7, 3) == 1);
}

BOOST_AUTO_TEST_CASE(speeds_are_ordered_and_closer_together_near_one) {
  const std::vector<double> ratios = curve_ratios();
  BOOST_TEST(std::is_sorted(ratios.begin(), ratios.end()));
  BOOST_TEST(ratios.size() >= 40u);
  BOOST_TEST(ratios.size() <= 60u);
  BOOST_TEST(std::count_if(ratios.begin(), ratios.end(), [](double r) { return r > 1; }) >= 3);
  BOOST_TEST(std::count_if(ratios.begin(), ratios.end(),
                           [](double r) { return std::abs(r - 1) < 0.02; }) >= 6);
  BOOST_TEST(std::count(ratios.begin(), ratios.end(), 1.0) == 0);
}

BOOST_AUTO_TEST_CASE(both_starts_must_agree_everywhere) {
  std::vector<ComparedPoint> points = curve();
  BOOST_TEST((outcome(compare_starts(points)) == Outcome::passed));
  points[2].from_rest += 1e-8;
  BOOST_TEST((outcome(compare_starts(points)) == Outcome::failed));
  BOOST_TEST(compare_starts(points).found == points[2].from_rest);
  points = curve();
  points[1].from_rest = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((outcome(compare_starts(points)) == Outcome::failed));
}

// Near resonance the simulator says that it loses digits: no more than those, at that speed alone.
BOOST_AUTO_TEST_CASE(what_the_simulator_says_that_it_loses_is_no_disagreement) {
  std::vector<ComparedPoint> points = curve();
  points[2].error = 1e-8;
  points[2].from_rest += 1.9e-8;
  BOOST_TEST((outcome(compare_starts(points)) == Outcome::passed));
  BOOST_TEST(compare_starts(points).tolerance == 2e-8);
  points[1].from_rest += 3e-9;
  BOOST_TEST((outcome(compare_starts(points)) == Outcome::failed));
  points = curve();
  points[2].error = 1e-8;
  points[2].from_rest += 2.1e-8;
  BOOST_TEST((outcome(compare_starts(points)) == Outcome::failed));
}

BOOST_AUTO_TEST_CASE(the_closed_form_must_be_met) {
  std::vector<ComparedPoint> points = curve();
  for (ComparedPoint& point : points) point.closed_form = point.from_sliding;
  BOOST_TEST((outcome(compare_closed_form(points)) == Outcome::passed));
  *points[3].closed_form -= 1e-8;
  BOOST_TEST((outcome(compare_closed_form(points)) == Outcome::failed));
}

BOOST_AUTO_TEST_SUITE_END()
