// The search along a row of places, on functions whose crossings are known in closed form.
#include "design/first_reach.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(test_first_reach)

namespace {

using namespace vcrit::design;

std::vector<double> places(double from, double to, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(from + (to - from) * i / (count - 1));
  return result;
}

// toms748 ends 2^-49 apart; one more rounding of the function's own.
constexpr double close = 4e-15;

BOOST_AUTO_TEST_CASE(the_first_of_several_crossings_is_found) {
  // cos x = 1/2 first at pi/3, then at 5 pi/3, 7 pi/3, ...
  const ReachSearch search =
      first_reach([](double x) { return std::cos(x); }, places(0, 20, 50), 0.5);
  BOOST_TEST_REQUIRE(search.reach.has_value());
  BOOST_TEST(std::abs(search.reach->at - std::numbers::pi / 3) < close);
  BOOST_TEST(std::cos(search.reach->at) <= 0.5);
  BOOST_TEST(std::cos(search.reach->before) >= 0.5);
  BOOST_TEST(search.reach->before <= search.reach->at);
}

BOOST_AUTO_TEST_CASE(a_falling_row_finds_the_largest) {
  // cos 19 = 0.989; going down, cos x = 1/2 first at 17 pi/3 = 17.80.
  const ReachSearch search =
      first_reach([](double x) { return std::cos(x); }, places(19, 0, 50), 0.5);
  BOOST_TEST_REQUIRE(search.reach.has_value());
  BOOST_TEST(std::abs(search.reach->at - 17 * std::numbers::pi / 3) < 19 * close);
  BOOST_TEST(search.reach->before >= search.reach->at);
}

BOOST_AUTO_TEST_CASE(a_dip_between_two_samples_is_searched) {
  // Samples at 0, 1, ..., 10; only between 4.7 +- 0.1 the function lies below 0.1.
  const auto dip = [](double x) { return std::abs(x - 4.7); };
  const ReachSearch search = first_reach(dip, places(0, 10, 11), 0.1);
  BOOST_TEST_REQUIRE(search.reach.has_value());
  BOOST_TEST(std::abs(search.reach->at - 4.6) < 10 * close);
}

BOOST_AUTO_TEST_CASE(what_is_never_reached_says_how_near_it_came) {
  const ReachSearch search =
      first_reach([](double x) { return 1 + (x - 2) * (x - 2); }, places(0, 5, 11), 0.9);
  BOOST_TEST(!search.reach.has_value());
  BOOST_TEST_REQUIRE(search.least.has_value());
  BOOST_TEST(*search.least == 1);
  BOOST_TEST(search.least_at == 2);
}

BOOST_AUTO_TEST_CASE(the_first_place_may_do) {
  const ReachSearch search = first_reach([](double x) { return x; }, places(1, 2, 5), 3);
  BOOST_TEST_REQUIRE(search.reach.has_value());
  BOOST_TEST(search.reach->at == 1);
  BOOST_TEST(search.evaluations == 1);
}

BOOST_AUTO_TEST_CASE(places_without_an_answer_do_not_reach) {
  const auto holed = [](double x) -> std::optional<double> {
    if (x > 2 && x < 6) return std::nullopt;
    return 10 - x;
  };
  const ReachSearch search = first_reach(holed, places(0, 10, 11), 7.5);
  BOOST_TEST_REQUIRE(search.reach.has_value());
  // 2.5 would do, but is not known to; 6 is the first place that is.
  BOOST_TEST(std::abs(search.reach->at - 6) < 10 * close);
  BOOST_TEST(search.unanswered >= 3);
  const ReachSearch nothing =
      first_reach([](double) { return std::nullopt; }, places(0, 1, 4), 0.5);
  BOOST_TEST(!nothing.reach.has_value());
  BOOST_TEST(!nothing.least.has_value());
  BOOST_TEST(nothing.unanswered == 4);
}

// As of a resonance, where fast drives have no answer: the root finder goes to numbers alone.
BOOST_AUTO_TEST_CASE(a_crossing_beside_a_hole_asks_for_numbers_alone) {
  int asked = 0;
  const auto fast_ones_are_lost = [&](double x) -> std::optional<double> {
    BOOST_TEST_REQUIRE(std::isfinite(x));
    ++asked;
    if (x > 2.5) return std::nullopt;
    return 0.25 * x;
  };
  const ReachSearch search = first_reach(fast_ones_are_lost, places(10, 0, 11), 0.99);
  BOOST_TEST_REQUIRE(search.reach.has_value());
  BOOST_TEST(std::abs(search.reach->at - 2.5) < 10 * close);
  BOOST_TEST(asked < 100);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
