// Derived formulas have the values of an independent nodal evaluation, and limits are what the
// formula tends to.
#include <boost/test/unit_test.hpp>

#include "analysis/exact_scene.hpp"
#include "analysis/limits.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

constexpr unsigned seed = 20240611;

}  // namespace

// 500 scenes of up to 30 elements in each network, evaluated in CLN at 50 digits.
BOOST_AUTO_TEST_CASE(random_scenes) {
  BOOST_TEST_MESSAGE("seed " << seed);
  GiNaC::Digits = 50;
  test::RandomScenes random(seed, 4);
  int nested = 0, graphs = 0;
  for (int i = 0; i < 500; ++i) {
    Scene scene = random.scene(i % 30 + 1);
    test::round_ratio(scene);
    const Derivation derivation = derive(scene);
    nested += derivation.definitions.empty() ? 0 : 1;
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    const GiNaC::numeric derived =
        value_at(derivation.critical_velocity, derivation.definitions, test::exact_values(scene));
    const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
    // The nested form loses nothing but near resonance, which takes a digit for each decade of
    // distance; CLN carries 57 digits where 50 are asked for. The nodal values carry 250 digits, of
    // which each of 60 nodes at most may take three to four over 8 decades.
    BOOST_TEST(test::agreement(derived, nodal) > 45, "scene " << i << " of seed " << seed);
  }
  // Both forms of the formula and graphs are among them.
  BOOST_TEST(nested > 100);
  BOOST_TEST(nested < 490);
  BOOST_TEST(graphs > 50);
}

namespace {

/// |v(T)/limit - 1| with the limit's symbols at their values times T^rate.
GiNaC::numeric distance(const Derivation& full, const Limit& limit,
                        std::map<Symbol, GiNaC::numeric> values, int decades) {
  const GiNaC::numeric at_limit = value_at(limit.result, limit.definitions, values);
  const GiNaC::numeric ten(10);
  for (const auto& [symbol, rate] : limit.rates)
    values.at(symbol) *= GiNaC::pow(ten, GiNaC::numeric(rate * decades));
  const GiNaC::numeric near = value_at(full.critical_velocity, full.definitions, values);
  return GiNaC::abs(near / at_limit - 1);
}

void check_limits(const Scene& scene, const std::map<Symbol, GiNaC::numeric>& values,
                  std::size_t expected) {
  const Derivation full = derive(scene);
  std::size_t checked = 0;
  for (const Limit& limit : limits(scene)) {
    if (limit.rates.empty()) continue;
    ++checked;
    const GiNaC::numeric far = distance(full, limit, values, 15);
    const GiNaC::numeric near = distance(full, limit, values, 25);
    // Rational functions approach their limits at least like C/T: ten decades in T are ten digits.
    // C is a ratio of values, far below T = 1e15, so that the first distance is small already.
    BOOST_TEST((far < GiNaC::numeric("1e-6")), limit.name);
    BOOST_TEST((near <= far * GiNaC::numeric("2e-10")), limit.name);
  }
  BOOST_TEST(checked == expected);
}

std::map<Symbol, GiNaC::numeric> some_values(const Scene& scene) {
  std::map<Symbol, GiNaC::numeric> values{{{"mu0"}, GiNaC::numeric(3, 10)},
                                          {{"omega"}, GiNaC::numeric(7, 3)},
                                          {{"du_z"}, GiNaC::numeric(1, 7)},
                                          {{"m"}, GiNaC::numeric(11, 13)},
                                          {{"nu"}, GiNaC::numeric(2, 7)}};
  int count = 0;
  for (const auto& [symbol, value] : scene.elements)
    values[symbol] = GiNaC::numeric(17 + 5 * count++, 19);
  return values;
}

}  // namespace

BOOST_AUTO_TEST_CASE(limits_are_approached) {
  GiNaC::Digits = 200;
  using test::scene_of;
  const auto check = [](const Scene& scene, std::size_t expected) {
    check_limits(scene, some_values(scene), expected);
  };
  // Kelvin: kd; m; cn to 0 only (the normal force would grow without end); ct to 0 and to infinity;
  // all dampers to 0; then kd.
  check(test::kelvin_scene(), 7);
  // Zener, isotropic: K_d; m; c1 to 0 and infinity; cd to 0, to infinity; all to 0; then K_d.
  check(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"), 8);
  // Burgers: c1 to 0 cuts the network; to infinity, and c2 both ways; kd.
  check(scene_of("normal = \"burgers(k1, c1, k2, c2)\"\ntangential_ratio = 0.7", "kd"), 4);
  // Prony, too large to be multiplied out: kd, m, tau to 0 and infinity, tau to 0 and kd.
  check(scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.25", "kd", "m"), 5);
  // The bridge: kd, m, c1 both, c2 both, ct both, all, all and kd.
  check(scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network),
        10);
  // Under a rigid drive: dampers of both networks to 0, all to 0; a rigid contact would not move.
  check(scene_of(test::kelvin_contact), 3);
}

BOOST_AUTO_TEST_CASE(limits_that_cut_a_network_are_left_out) {
  const auto names = [](const Scene& scene) {
    std::vector<std::string> result;
    for (const Limit& limit : limits(scene)) result.push_back(limit.name);
    return result;
  };
  // c1 to 0 cuts the normal network, c2 to 0 the tangential one; both may grow.
  BOOST_TEST((names(test::scene_of("normal = \"k1 - c1\"\ntangential = \"k2 - c2\"")) ==
              std::vector<std::string>{"c1 -> infinity", "c2 -> infinity",
                                       "isotropic contact, K_t = k2*K_n/k1"}));
}
