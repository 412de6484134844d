// Derived formulas have the values of an independent nodal evaluation, and limits are what the
// formula tends to.
#include <boost/test/unit_test.hpp>

#include <cmath>

#include "analysis/limits.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

constexpr unsigned seed = 20240611;

std::map<Symbol, GiNaC::numeric> exact_values(const Scene& scene) {
  std::map<Symbol, GiNaC::numeric> values;
  for (const auto& [symbol, value] : values_of(scene)) values[symbol] = exact_binary(value);
  return values;
}

/// Decimals of doubles with few bits are those doubles, so that the fraction that the derivation
/// reads and the double that the nodal evaluation takes are one number.
void round_ratio(Scene& scene) {
  if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    isotropic->quantity.value = std::ceil(*isotropic->quantity.value * 64) / 128;
}

GiNaC::numeric number(const test::Real& value) {
  return GiNaC::numeric(value.str(120, std::ios::scientific).c_str());
}

/// Digits in which two numbers agree.
double agreement(const GiNaC::numeric& a, const GiNaC::numeric& b) {
  if (a.is_equal(b)) return 1000;
  return -(GiNaC::log(GiNaC::abs((a - b) / b)) / GiNaC::log(GiNaC::numeric(10))).to_double();
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_scenes) {
  BOOST_TEST_MESSAGE("seed " << seed);
  GiNaC::Digits = 150;
  test::RandomScenes random(seed, 4);
  int nested = 0, graphs = 0;
  for (int i = 0; i < 100; ++i) {
    Scene scene = random.scene(i % 12 + 1);
    round_ratio(scene);
    const Derivation derivation = derive(scene);
    nested += derivation.definitions.empty() ? 0 : 1;
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    const GiNaC::numeric derived =
        value_at(derivation.critical_velocity, derivation.definitions, exact_values(scene));
    const GiNaC::numeric nodal = number(test::critical_velocity_by_nodes(scene));
    // 24 terms over 8 decades each lose at most some 24*8/2 of the 150 digits carried (multiplied
    // out, the nested form loses none); the nodal values carry 250.
    BOOST_TEST(agreement(derived, nodal) > 50, "scene " << i << " of seed " << seed);
  }
  // Both forms of the formula and graphs are among them.
  BOOST_TEST(nested > 10);
  BOOST_TEST(nested < 90);
  BOOST_TEST(graphs > 5);
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
