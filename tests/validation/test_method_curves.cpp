// Friction by the methods beside the exact one: near where they promise, silent where they cannot.
#include "compare/method_curves.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "critical/certified.hpp"
#include "scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(test_method_curves)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

std::vector<MethodCurve> curves_of(const std::string& file) {
  const Scene scene = read_scene(VCRIT_SCENES "/" + file);
  return method_curves(simulation::system_of(scene), certified_critical_velocity(scene).value);
}

const MethodCurve* find(const std::vector<MethodCurve>& curves, const std::string& method) {
  const auto found = std::find_if(curves.begin(), curves.end(),
                                  [&](const MethodCurve& curve) { return curve.method == method; });
  return found == curves.end() ? nullptr : &*found;
}

double worst(const MethodCurve& curve) {
  double result = 0;
  for (const MethodPoint& point : curve.points) result = std::max(result, point.difference);
  return result;
}

}  // namespace

// Tolerance 1e-10 a step, some hundred steps a period: 1e-7 leaves room for ten times that.
BOOST_AUTO_TEST_CASE(integrators_come_near_the_exact_method) {
  const auto curves = curves_of("zener.toml");
  for (const char* name : {"rkf45", "rk8pd"}) {
    const MethodCurve* curve = find(curves, name);
    BOOST_REQUIRE(curve != nullptr);
    BOOST_TEST(curve->points.size() == 12u);
    BOOST_TEST(worst(*curve) < 1e-7);
  }
  BOOST_TEST(find(curves, "reduced") == nullptr);  // of a Kelvin contact alone
}

// docs/physics: the reduced model is right without dampers, and wrong by percents with them.
BOOST_AUTO_TEST_CASE(the_reduced_model_stands_where_it_applies) {
  const auto elastic = curves_of("elastic.toml"), kelvin = curves_of("kelvin_rigid.toml");
  BOOST_REQUIRE(find(elastic, "reduced") != nullptr);
  BOOST_TEST(worst(*find(elastic, "reduced")) < 1e-9);
  BOOST_REQUIRE(find(kelvin, "reduced") != nullptr);
  BOOST_TEST(worst(*find(kelvin, "reduced")) > 1e-2);
}

BOOST_AUTO_TEST_SUITE_END()
