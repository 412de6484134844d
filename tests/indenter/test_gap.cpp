// The one-dimensional profile of every shape by its definition, integrated another way, and its
// inverse.
#include "normal/gap.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "base/errors.hpp"
#include "indenter/half_spaces.hpp"

BOOST_AUTO_TEST_SUITE(test_gap)

namespace {

using namespace vcrit;
using indenter::Gap;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// |x| int_0^|x| f'(r)/sqrt(x^2 - r^2) dr with r = x sin a: |x| int_0^{pi/2} f'(x sin a) da. The
// slope of f is smooth between the given angles.
double by_definition(const std::function<double(double)>& slope, double x,
                     const std::vector<double>& radii = {}) {
  boost::math::quadrature::tanh_sinh<double> integrator;
  std::vector<double> angles{0};
  for (const double r : radii)
    if (r > 0 && r < x) angles.push_back(std::asin(r / x));
  angles.push_back(std::acos(0.0));
  double sum = 0;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    sum += integrator.integrate([&](double a) { return slope(x * std::sin(a)); }, angles[i],
                                angles[i + 1], 1e-14);
  return x * sum;
}

Gap table(const std::vector<Profile::Row>& rows) {
  return Gap(Indenter{Indenter::Shape::table, {}, Profile{"table.csv", rows}});
}

Gap of(const std::string& indenter) {
  return Gap(*reference::scene_of(indenter, 1e-6, 1e-6).indenter);
}

// Some ten rounding errors in a closed form, and the integrator's 1e-14.
constexpr double relative = 1e-13;

}  // namespace

BOOST_AUTO_TEST_CASE(cone) {
  const Gap gap = of("shape = \"cone\"\nangle = 0.1");
  for (const double x : {1e-7, 1e-3, 2.0}) {
    BOOST_TEST(std::abs(gap.at(x) / (std::acos(0.0) * x * std::tan(0.1)) - 1) <= relative);
    BOOST_TEST(gap.at(-x) == gap.at(x));
  }
}

BOOST_AUTO_TEST_CASE(parabola) {
  const Gap gap = of("shape = \"parabola\"\nradius = \"10 mm\"");
  for (const double x : {1e-7, 1e-4, 1e-2})
    BOOST_TEST(std::abs(gap.at(x) / (x * x / 0.01) - 1) <= relative);
}

BOOST_AUTO_TEST_CASE(power) {
  for (const double n : {0.5, 1.0, 2.0, 2.5, 3.0, 8.0}) {
    const Gap gap = of("shape = \"power\"\nprefactor = 3\nexponent = " + std::to_string(n));
    for (const double x : {1e-3, 0.3}) {
      const double expected =
          by_definition([&](double r) { return 3 * n * std::pow(r, n - 1); }, x);
      BOOST_TEST(std::abs(gap.at(x) / expected - 1) <= relative, n << " " << x);
    }
  }
}

BOOST_AUTO_TEST_CASE(flat) {
  const Gap gap = of("shape = \"flat\"\nradius = \"2 mm\"");
  BOOST_TEST(gap.flat());
  BOOST_TEST(gap.at(1.9e-3) == 0);
  BOOST_TEST(std::isinf(gap.at(2.1e-3)));
  BOOST_TEST(gap.half_width(1e-6) == 2e-3);
  BOOST_TEST(gap.half_width(-1e-6) == 0);
}

BOOST_AUTO_TEST_CASE(straight_lines) {
  // A flat tip, steeper and steeper, and a slope that decreases but leaves g growing.
  const std::vector<Profile::Row> rows{{0, 0}, {1, 0}, {2, 0.5}, {3, 2}, {4, 3.49}, {6, 7.4}};
  const Gap gap = table(rows);
  BOOST_TEST(!gap.flat());
  BOOST_TEST(gap.end() == 6);
  const std::vector<double> slopes{0, 0.5, 1.5, 1.49, 1.955};
  const auto slope = [&](double r) {
    std::size_t i = 0;
    while (i + 1 < slopes.size() && rows[i + 1].r < r) ++i;
    return slopes[i];
  };
  BOOST_TEST(gap.at(0.5) == 0);
  for (const double x : {1.001, 1.5, 2.0, 2.5, 3.7, 4.0001, 5.0, 6.0})
    BOOST_TEST(std::abs(gap.at(x) / by_definition(slope, x, {1, 2, 3, 4}) - 1) <= relative, x);
  BOOST_TEST(std::isinf(gap.at(6.001)));
}

// Straight lines deviate from a parabola by h^2/(8 R) at most, and in slope by h/(2 R).
BOOST_AUTO_TEST_CASE(table_of_a_parabola) {
  for (const int n : {10, 100, 1000}) {
    std::vector<Profile::Row> rows;
    for (int i = 0; i <= n; ++i) {
      const double r = static_cast<double>(i) / n;
      rows.push_back({r, r * r / 2});
    }
    const Gap gap = table(rows);
    const double h = 1.0 / n;
    for (const double x : {0.1, 0.333, 0.7, 0.999}) {
      // x int (f' - r/R)/sqrt(x^2 - r^2) dr: the deviation of up to h/2 has no mean between rows.
      // Up to the last row but one below x, by parts, h^2/8 times the weight there; from there on
      // h/2 over an angle of sqrt(4 h/x): together below h sqrt(h x) (1 + 1/8).
      const double bound = 1.2 * h * std::sqrt(h * x);
      BOOST_TEST(std::abs(gap.at(x) - x * x) <= bound, n << " " << x);
    }
  }
}

BOOST_AUTO_TEST_CASE(inverse) {
  const std::vector<Gap> gaps{
      of("shape = \"cone\"\nangle = 0.1"), of("shape = \"parabola\"\nradius = \"10 mm\""),
      of("shape = \"power\"\nprefactor = 3\nexponent = 2.5"),
      table({{0, 0}, {1e-4, 0}, {2e-4, 5e-7}, {3e-4, 2e-6}, {4e-4, 3.49e-6}, {6e-4, 8e-6}})};
  for (const Gap& gap : gaps)
    for (const double depth : {1e-8, 3e-7, 4e-6}) {
      const double x = gap.half_width(depth);
      // x is right to some rounding errors, and g with it by x g'/g < 4; near the flat tip by the
      // root of its growth.
      BOOST_TEST(gap.at(x * (1 - 8 * epsilon)) <= depth);
      BOOST_TEST(gap.at(x * (1 + 8 * epsilon)) >= depth);
    }
  BOOST_TEST(gaps.back().half_width(0) == 1e-4);
  BOOST_TEST(gaps.back().half_width(1) == 6e-4);
  BOOST_TEST(gaps.front().half_width(-1e-9) == 0);
}

// After a step, g falls; after a slight change of slope by a part d, by d^2 of itself.
BOOST_AUTO_TEST_CASE(concave) {
  BOOST_CHECK_EXCEPTION(table({{0, 0}, {1, 0}, {1.1, 1}, {3, 1}}), ModelError,
                        [](const ModelError& error) {
                          return std::string(error.what()).find("holes") != std::string::npos;
                        });
  BOOST_CHECK_THROW(table({{0, 0}, {1, 1}, {2, 1.5}}), ModelError);
  BOOST_CHECK_NO_THROW(table({{0, 0}, {1, 1}, {2, 1.9999}}));
  // The fall after r = 1 is (d^2 r)/(2 g') = d^2/pi for slopes 1 and 1 - d; g = pi/2 there.
  const double limit = std::sqrt(1e-6 * std::acos(0.0) * 2 * std::acos(0.0));
  BOOST_CHECK_NO_THROW(table({{0, 0}, {1, 1}, {2, 2 - 0.5 * limit}}));
  BOOST_CHECK_THROW(table({{0, 0}, {1, 1}, {2, 2 - 2 * limit}}), ModelError);
}

BOOST_AUTO_TEST_CASE(flat_table) {
  const Gap gap = table({{0, 0}, {1, 0}, {2, 0}});
  BOOST_TEST(gap.flat());
  BOOST_TEST(gap.half_width(0) == 2);
  BOOST_TEST(gap.at(2) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
