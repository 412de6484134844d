// How low free swings at harmonics can make the maximum of cos t, against closed forms: all
// harmonics up to N make of E - cos t - ... a polynomial of degree N that is nowhere negative, and
// of those Fejer found the largest share of the first harmonic, 2 cos(pi/(N + 2)).
#include "base/free_swings.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <set>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/interruption.hpp"

BOOST_AUTO_TEST_SUITE(test_free_swings)

namespace {

using namespace vcrit;

constexpr double width = 1e-12;  // of the enclosure, as promised

bool encloses(const LeastMaximum& found, double expected) {
  const double rounding = 4 * epsilon;
  return found.lower <= expected + rounding && expected - rounding <= found.upper &&
         found.upper - found.lower <= width;
}

std::vector<int> drawn(std::mt19937& random, int most) {
  std::set<int> some;
  const std::size_t count = 2 + random() % 3;
  while (some.size() < count) some.insert(2 + static_cast<int>(random() % most));
  return {some.begin(), some.end()};
}

// A lower bound of the maximum of cos t and these swings, by nothing but their sum.
double highest_of_a_grid(const std::vector<int>& harmonics, const std::vector<double>& swings) {
  double highest = -1;
  for (int i = 0; i <= 2000; ++i) {
    const double t = pi * i / 2000;
    double sum = std::cos(t);
    for (std::size_t j = 0; j < harmonics.size(); ++j)
      sum += swings[j] * std::cos(harmonics[j] * t);
    highest = std::max(highest, sum);
  }
  return highest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(work_is_bounded) {
  BOOST_TEST(least_maximum({2, 13, 24, 35, 46, 57, 68, 79, 100}).has_value());
  BOOST_TEST(!least_maximum({2, 3, 4, 5, 6, 7, 8, 9, 10, 11}).has_value());
}

BOOST_AUTO_TEST_CASE(it_can_be_interrupted) {
  struct Interrupted {};
  const Interruptible asked([] { throw Interrupted{}; });
  BOOST_CHECK_THROW(least_maximum({2, 3}), Interrupted);
}

BOOST_AUTO_TEST_CASE(what_was_asked_last_is_known) {
  struct Computed {};
  const LeastMaximum first = *least_maximum({2, 5});
  const Interruptible asked([] { throw Computed{}; });
  const LeastMaximum again = *least_maximum({2, 5});
  BOOST_TEST(again.lower == first.lower);
  BOOST_TEST(again.upper == first.upper);
  BOOST_TEST(again.swings == first.swings, boost::test_tools::per_element());
  for (const std::vector<int>& others :
       {std::vector{2, 7}, std::vector{2, 5, 7}, std::vector{3, 5}})
    BOOST_CHECK_THROW(least_maximum(others), Computed);
  BOOST_TEST(least_maximum({2, 5})->upper == first.upper);
}

BOOST_AUTO_TEST_CASE(one_harmonic_or_none) {
  BOOST_TEST(least_maximum({})->upper == 1);
  for (const int n : {2, 3, 4, 17, 100})
    BOOST_TEST(least_maximum({n})->upper == std::cos(pi / (2 * n)));
}

BOOST_AUTO_TEST_CASE(all_harmonics_up_to_one) {
  std::vector<int> harmonics{2};
  for (int n = 3; n <= 7; ++n) {
    harmonics.push_back(n);
    BOOST_TEST(encloses(*least_maximum(harmonics), 1 / (2 * std::cos(pi / (n + 2)))), n);
  }
}

// At the two instants that decide for n no swing at an odd multiple of n has a mean either.
BOOST_AUTO_TEST_CASE(odd_multiples_add_nothing) {
  for (const int n : {2, 3, 5})
    for (const int odd : {3, 5, 7})
      BOOST_TEST(encloses(*least_maximum({n, odd * n}), std::cos(pi / (2 * n))), n << " " << odd);
}

BOOST_AUTO_TEST_CASE(two_harmonics) {
  BOOST_TEST(encloses(*least_maximum({2, 4}), 2.0 / 3));
  BOOST_TEST(encloses(*least_maximum({3, 5}), 2 * std::sqrt(2.0) - 2));
  BOOST_TEST(encloses(*least_maximum({5, 7}), 4 * std::sqrt(3.0) - 6));
}

BOOST_AUTO_TEST_CASE(more_harmonics_never_raise_it) {
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const std::vector<int> all = drawn(random, 20);
    const LeastMaximum together = *least_maximum(all);
    BOOST_TEST(together.upper - together.lower <= width);
    BOOST_TEST(highest_of_a_grid(all, together.swings) <= together.upper + 8 * epsilon);
    for (const int n : all) {
      std::vector<int> fewer = all;
      std::erase(fewer, n);
      BOOST_TEST(together.lower <= least_maximum(fewer)->upper);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
