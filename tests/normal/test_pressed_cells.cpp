// An elastic sphere under a load: the mean of Hertz's force over a period, from hardly tapping to
// hardly moving.
#include "normal/pressed_cells.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_pressed_cells)

namespace {

using namespace vcrit;

constexpr double amplitude = 0.5, radius = 2, modulus = 0.91 / (1 - 0.3 * 0.3);

// Mean of 4/3 E* sqrt(R) u^{3/2} over a period, u = amplitude (cos t + depth), while u > 0. In
// t = closed sin s the power starts and ends smoothly.
double hertz(double depth) {
  const double pi = std::numbers::pi;
  const double closed = depth >= 1 ? pi : 2 * std::asin(std::sqrt(0.5 * (1 + depth)));
  const auto at = [&](double s) {
    const double t = closed * std::sin(s);
    // cos t - cos closed by the product, which does not cancel.
    const double off = depth >= 1
                           ? depth + std::cos(t)
                           : 2 * std::sin(0.5 * (closed + t)) *
                                 std::sin(closed * std::pow(std::sin(0.25 * pi - 0.5 * s), 2));
    return std::pow(amplitude * off, 1.5) * closed * std::cos(s);
  };
  const double whole =
      boost::math::quadrature::gauss_kronrod<double, 61>::integrate(at, 0.0, 0.5 * pi, 15, 1e-14);
  return 4.0 / 3 * modulus * std::sqrt(radius) * whole / pi;
}

double indentation_under(double load) {
  test::SceneText text{.normal = "spring(E0)", .poisson = 0.3, .separation = true};
  text.indenter = "shape = \"parabola\"\nradius = 2\n";
  text.amplitude = amplitude;
  text.indentation = {};
  text.more = test::section("load", test::Toml(load).line("force"));
  text.elements = {{"E0", 0.91}};
  return simulation::indentation_of_cells(test::scene_of(text));
}

}  // namespace

// The search ends with a step below 1e-13 of the amplitude; the panels are right to 1e-12.
BOOST_AUTO_TEST_CASE(an_elastic_sphere_is_as_deep_as_hertz_says) {
  for (const double above : {1e-9, 1e-6, 1e-3, 0.1, 0.5, 0.999, 1.0, 1.5, 1.999, 2.0, 3.0, 100.0})
    BOOST_TEST_CONTEXT("above the lowest depth by " << above) {
      const double load = hertz(above - 1);
      const double found = indentation_under(load) / amplitude + 1;
      BOOST_TEST(std::abs(found - above) <= 1e-13 + 1e-12 * above);
    }
}

BOOST_AUTO_TEST_SUITE_END()
