// Slopes by differences against derivatives by hand: of smooth functions, beside a bend and at it,
// next to a border with a singular curvature, and through noise.
#include "answers/slope.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(test_slope)

using namespace vcrit;

namespace {

constexpr double rounding = 1e-15;  // of values of about 1

// Noise over a step of 1e-3, times 1.5, and the fifth derivative, at most 3, times the step^4/30.
constexpr double of_rounding = 2e-12;

}  // namespace

BOOST_AUTO_TEST_CASE(smooth_functions) {
  const auto near = [](const Slope& slope, double expected) {
    BOOST_TEST(std::abs(slope.value - expected) <= of_rounding);
    BOOST_TEST(slope.error <= 1e-9);
  };
  near(slope_at_zero([](double x) { return std::exp(0.7 * x); }, rounding), 0.7);
  near(slope_at_zero([](double x) { return 3 * std::sin(x); }, rounding), 3);
  near(slope_at_zero([](double) { return 5.0; }, rounding), 0);
}

// To one side of the bend the slope is 1, to the other 3: known beside it, as near as the noise
// allows, and never given where it bends.
BOOST_AUTO_TEST_CASE(beside_a_bend_and_at_it) {
  const auto bent_at = [](double place) {
    return slope_at_zero([place](double x) { return x < place ? x : 3 * x - 2 * place; }, rounding);
  };
  for (const double place : {1e-2, 1e-3, 1e-4, 1e-6}) {
    const Slope before = bent_at(place), behind = bent_at(-place);
    BOOST_TEST(before.error <= 1e-6, place);
    BOOST_TEST(behind.error <= 1e-6, place);
    BOOST_TEST(std::abs(before.value - 1) <= before.error, place);
    BOOST_TEST(std::abs(behind.value - 3) <= behind.error, place);
  }
  const Slope at = bent_at(0);
  BOOST_TEST(at.error >= 1.9);
  BOOST_TEST(std::abs(at.below - 1) <= 1e-6);
  BOOST_TEST(std::abs(at.above - 3) <= 1e-6);
}

// As v* where the contact begins to open: x^(3/2) to one side, nothing to the other.
BOOST_AUTO_TEST_CASE(next_to_a_singular_curvature) {
  for (const double place : {0.0, 1e-7, 1e-5, 1e-3}) {
    const Slope slope = slope_at_zero(
        [place](double x) { return 1 + std::pow(std::max(0.0, x + place), 1.5); }, rounding);
    BOOST_TEST(std::abs(slope.value - 1.5 * std::sqrt(place)) <= slope.error, place);
    BOOST_TEST(slope.error <= 1e-3, place);
  }
}

// Values known to six digits are differenced over longer steps; of those known to two nothing is
// said.
BOOST_AUTO_TEST_CASE(noise_is_in_the_error) {
  std::mt19937 random(3);
  for (const double noise : {1e-9, 1e-6, 1e-2}) {
    std::uniform_real_distribution<double> off(-noise, noise);
    const Slope slope =
        slope_at_zero([&](double x) { return std::exp(0.7 * x) + off(random); }, noise);
    BOOST_TEST(std::abs(slope.value - 0.7) <= slope.error);
    BOOST_TEST(slope.error <= (noise < 1e-3 ? 3e-4 : 2.0));
    BOOST_TEST((noise < 1e-3 || slope.error >= 0.1));
  }
}

BOOST_AUTO_TEST_CASE(where_values_are_missing) {
  const auto known_below = [](double place) {
    return slope_at_zero(
        [place](double x) { return x < place ? std::optional(2 * x) : std::nullopt; }, rounding);
  };
  BOOST_TEST(std::abs(known_below(1e-4).value - 2) <= 1e-8);
  BOOST_TEST(std::isinf(known_below(0).error));
}

BOOST_AUTO_TEST_SUITE_END()
