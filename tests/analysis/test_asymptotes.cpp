// v* at low and high frequency: leading powers and coefficients.
#include <boost/test/unit_test.hpp>

#include "analysis/asymptotes.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "derivation/values.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_asymptotes)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

/// |v*/(coefficient omega^power) - 1| with omega `decades` beyond its value, on the asymptote's
/// way.
GiNaC::numeric distance(const Derivation& full, const Asymptote& asymptote,
                        test::ExactValues values, int decades) {
  const GiNaC::numeric coefficient = value_at(asymptote.coefficient, asymptote.definitions, values);
  const bool high = asymptote.name == "omega -> infinity";
  GiNaC::numeric& omega = values.at({"omega"});
  omega *= GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(high ? decades : -decades));
  const GiNaC::numeric near = value_at(full.critical_velocity, full.definitions, values);
  const GiNaC::numeric power = GiNaC::pow(omega, GiNaC::numeric(asymptote.power));
  return GiNaC::abs(near / (coefficient * power) - 1);
}

// v*^2 = omega^2 B(i omega) B(-i omega) is a rational function of omega^2, so that v* differs from
// its leading term by a factor 1 + C omega^2 + ... at low and 1 + C/omega^2 + ... at high
// frequency: ten decades in omega are twenty digits. C is a ratio of values, far below 10^14. Of
// 200 digits, polynomials whose terms lie 22 decades a power apart leave more than 100 where C is
// 0.
const char* const rounding = "1e-100";

void check(const Scene& scene, const test::ExactValues& values) {
  const Derivation full = derive(scene);
  const std::vector<Asymptote> both = asymptotes(derive(scene));
  BOOST_REQUIRE(both.size() == 2u);
  for (const Asymptote& asymptote : both) {
    const GiNaC::numeric far = distance(full, asymptote, values, 12);
    const GiNaC::numeric near = distance(full, asymptote, values, 22);
    BOOST_TEST((far < GiNaC::numeric("1e-10")), asymptote.name);
    BOOST_TEST((near <= far * GiNaC::numeric("1.001e-20") + GiNaC::numeric(rounding)),
               asymptote.name);
  }
}

struct Texts {
  std::string coefficient;
  int power;
};

void expect(const Scene& scene, const Texts& low, const Texts& high) {
  const std::vector<Asymptote> both = asymptotes(derive(scene));
  BOOST_TEST(to_text(both[0].coefficient) == low.coefficient);
  BOOST_TEST(both[0].power == low.power);
  BOOST_TEST(to_text(both[1].coefficient) == high.coefficient);
  BOOST_TEST(both[1].power == high.power);
}

}  // namespace

// Worked out by hand from Eq. 24.
BOOST_AUTO_TEST_CASE(powers_and_coefficients) {
  expect(test::kelvin_scene(), {"mu0*du_z*kn*(kd + kt)/(kd*kt)", 1}, {"mu0*du_z*cn/ct", 1});
  expect(scene_of("normal = \"kn | cn\"\ntangential = \"kt\""), {"mu0*du_z*kn/kt", 1},
         {"mu0*du_z*cn/kt", 2});
  expect(scene_of("normal = \"kn\"\ntangential = \"ct\""), {"mu0*du_z*kn/ct", 0},
         {"mu0*du_z*kn/ct", 0});
  // A drive that is a damper gives way at low frequency; a mass holds still at high frequency.
  expect(scene_of("normal = \"kn\"\ntangential = \"kt\"", "cd", "m"), {"mu0*du_z*kn/cd", 0},
         {"mu0*du_z*kn/kt", 1});
  expect(scene_of("normal = \"kn | cn\"\npoisson = \"nu\"", "kd | cd", "m"),
         {"mu0*du_z*(2*kd + 2*kn - 2*kn*nu - kd*nu)/(2*kd*(1 - nu))", 1},
         {"mu0*du_z*(2 - nu)/(2*(1 - nu))", 1});
}

BOOST_AUTO_TEST_CASE(asymptotes_are_approached) {
  GiNaC::Digits = 200;
  const auto approach = [](const Scene& scene) { check(scene, test::some_values(scene)); };
  approach(test::kelvin_scene());
  approach(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"));
  approach(scene_of("normal = \"burgers(k1, c1, k2, c2)\"\ntangential_ratio = 0.7", "kd"));
  approach(scene_of("normal = \"prony(k0, k, tau, 12)\"\ntangential = \"kt | ct\"", "kd", "m"));
  approach(
      scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network));
  approach(scene_of("normal = \"kn | cs\"\ntangential = \"kt - cs\"", "cs | kd", "m"));
  approach(scene_of(test::kelvin_contact));
}

BOOST_AUTO_TEST_CASE(large_coefficients_stay_nested) {
  GiNaC::Digits = 200;
  const Scene scene =
      scene_of("normal = \"prony(k0, k, tau, 30)\"\ntangential = \"kt - c1\"", "kd - cd", "m");
  const Asymptote high = asymptotes(derive(scene))[1];
  BOOST_TEST(to_text(high.coefficient) == "mu0*du_z*L_n/L_t");
  BOOST_TEST(to_text(high.definitions.back().right) == "kt");
  check(scene, test::some_values(scene));
}

BOOST_AUTO_TEST_CASE(asymptotes_of_random_scenes_are_approached) {
  GiNaC::Digits = 200;
  constexpr unsigned seed = 20240613;
  BOOST_TEST_MESSAGE("seed " << seed);
  test::RandomScenes random(seed, 0.5);
  int graphs = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = random.scene(i % 10 + 1);
    test::round_ratio(scene);
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    BOOST_TEST_CONTEXT("scene " << i) { check(scene, test::exact_values(scene)); }
  }
  BOOST_TEST(graphs > 3);
}

BOOST_AUTO_TEST_SUITE_END()
