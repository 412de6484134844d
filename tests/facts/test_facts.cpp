// What a formula says in words, of scenes whose formulas are known by hand, and the largest closed
// amplitude beside the rulebook's numbers.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

#include "critical/admissibility.hpp"
#include "derivation/loaded.hpp"
#include "derivation/scenes.hpp"
#include "facts/closed_amplitude.hpp"
#include "facts/dependence.hpp"
#include "facts/facts.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "shortest/value_of.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_facts)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

std::vector<std::string> texts_of(const Scene& scene) {
  const NamesOfScene names(scene);
  std::vector<std::string> texts;
  for (const Fact& fact : facts(derive(scene))) texts.push_back(text_of(fact));
  return texts;
}

std::vector<std::string> keys_of(const Scene& scene) {
  std::vector<std::string> keys;
  for (const Fact& fact : facts(derive(scene))) keys.push_back(fact.key);
  return keys;
}

const std::string zener = "normal = \"zener(k0, k1, c1)\"\n", nu = "poisson = 0.3";

using Texts = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(the_rheology_of_an_isotropic_contact_cancels_under_a_rigid_drive) {
  const Texts texts = texts_of(scene_of(zener + nu));
  BOOST_TEST(texts.at(0) ==
             "With a rigid drive the rheology of an isotropic contact cancels: "
             "v* = 17/14*mu0*omega*du_z");
  BOOST_TEST(texts.size() == 2u);
  BOOST_TEST((keys_of(scene_of(zener + nu, "kd")) == Texts{"closed_amplitude"}));
}

// |K_n|/|K_t| = 1 where both networks are one, however it is written.
BOOST_AUTO_TEST_CASE(what_cancels_otherwise) {
  const std::string twice = "tangential = \"(c1 - k1) | k0\"";
  BOOST_TEST(keys_of(scene_of(zener + twice)).at(0) == "elements_cancel");
  BOOST_TEST(keys_of(scene_of(zener + nu, "zener(k0, k1, c1)")).at(0) == "elements_cancel");
}

// A balanced bridge has nothing between its inner nodes: K = k1 whatever c1 is.
BOOST_AUTO_TEST_CASE(what_does_not_enter) {
  const std::string bridge =
      "[networks.bridge]\nterminals = [\"a\", \"b\"]\n"
      "edges = [[\"k1\", \"a\", \"1\"], [\"k1\", \"a\", \"2\"], [\"c1\", \"1\", \"2\"], "
      "[\"k1\", \"1\", \"b\"], [\"k1\", \"2\", \"b\"]]\n";
  const Scene scene = scene_of("normal = \"bridge\"\ntangential = \"kt\"", "", "", bridge);
  const Texts texts = texts_of(scene);
  BOOST_TEST(texts.at(0) == "c1 does not enter v*");
  BOOST_TEST(keys_of(scene).at(1) == "proportional_to_frequency");
  BOOST_TEST(is_independent_of(*derive(scene).model, {"c1"}));
  BOOST_TEST(!is_independent_of(*derive(scene).model, {"c1", "k1"}));
}

BOOST_AUTO_TEST_CASE(springs_alone_leave_the_frequency_as_a_factor) {
  const Scene springs = scene_of("normal = \"k0\"\n" + nu, "kd");
  BOOST_TEST(keys_of(springs).at(0) == "proportional_to_frequency");
  BOOST_TEST(is_proportional_to_frequency(*derive(springs).model));
  for (const Scene& other :
       {scene_of(zener + nu, "kd"), scene_of("normal = \"k0\"\n" + nu, "kd", "m")})
    BOOST_TEST(!is_proportional_to_frequency(*derive(other).model));
}

BOOST_AUTO_TEST_CASE(resonances_are_told_with_their_frequency) {
  const Texts elastic = texts_of(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m"));
  const auto told = [](const Texts& texts, const std::string& end) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.ends_with(end); });
  };
  BOOST_TEST(told(elastic, ": omega = sqrt(kd/m)"));
  BOOST_TEST(told(elastic, ": omega = sqrt((kd + kt)/m)"));
  const Texts damped = texts_of(scene_of(zener + nu, "kd | cd", "m"));
  BOOST_TEST(told(damped, "Dampers keep v* finite and above 0 at every frequency"));
  // The mount has none.
  const Texts mounted = texts_of(scene_of("normal = \"kn\"\ntangential = \"kt | ct\"", "kd | cd",
                                          "m", "[mount]\nnetwork = \"km\"\nmass = \"m\"\n"));
  BOOST_TEST(told(mounted, "resonate along the normal: omega = sqrt((km + kn)/m)"));
  BOOST_TEST(told(mounted, "Dampers keep v* above 0 at every frequency"));
}

// By hand: K(0) = k0, |K|^2 = (k0^2 + T^2 (k0 + k1)^2)/(1 + T^2), T = omega c1/k1: 13 operations.
BOOST_AUTO_TEST_CASE(closed_amplitude_of_zener) {
  const Scene scene = scene_of(zener + nu);
  const ShortestForm form = find_closed_amplitude(scene).form.value();
  BOOST_TEST(form.operations <= 13);
  const double k0 = 2, k1 = 3, T = 0.7;
  std::map<std::string, double> names{
      {"k0", k0}, {"k1", k1}, {"c1", 0.5}, {"omega", T * k1 / 0.5}, {"u_z0", 1.3}};
  for (const auto& each : form.definitions)
    names[each.name.text] = test::value_of(each.meaning, names);
  BOOST_TEST(test::value_of(form.velocity, names) ==
                 1.3 * k0 * std::sqrt((1 + T * T) / (k0 * k0 + T * T * (k0 + k1) * (k0 + k1))),
             boost::test_tools::tolerance(1e-14));
  // K(0) = k, |K| = k sqrt(1 + eta^2)
  BOOST_TEST(texts_of(scene_of("normal = \"lossy(k, eta)\"\ntangential = \"kt\"")).back() ==
             "The contact stays closed while du_z is below du_max: du_max = u_z0/sqrt(1 + eta^2)");
  const Scene kelvin = scene_of("normal = \"kn | cn\"\ntangential = \"kt\"");
  const NamesOfScene of_kelvin(kelvin);
  BOOST_TEST(texts_of(kelvin).back() ==
             "The contact stays closed while du_z is below du_max: du_max = "
             "u_z0/sqrt(1 + (omega*cn/kn)^2)");
}

BOOST_AUTO_TEST_CASE(what_flows_stays_closed_at_no_amplitude) {
  const Scene scene = scene_of("normal = \"k1 - c1\"\n" + nu);
  BOOST_TEST(!carries_load(scene));
  BOOST_TEST(!find_closed_amplitude(scene).form);
  BOOST_TEST(texts_of(scene).back() ==
             "No amplitude keeps the contact closed: the normal network "
             "carries no static load, K_n = 0 at rest");
  const Fact fact = facts(derive(scene)).back();  // whose K_n = 0 is mathematics
  BOOST_TEST(std::any_of(fact.words.parts().begin(), fact.words.parts().end(),
                         [](const Prose::Part& part) { return !part.statement.empty(); }));
}

// The rulebook opens the contact at du_z |K_n| > u_z0 K_n(0), of numbers in long doubles and by
// another reduction. The form in doubles loses some 100 roundings of 1e-16.
BOOST_AUTO_TEST_CASE(the_closed_amplitude_is_that_of_the_rulebook) {
  test::RandomScenes random(20261125, 3);
  int compared = 0;
  for (int i = 0; i < 120; ++i) {
    Scene scene = random.scene(i % 6 + 1);
    const FoundForm found = find_closed_amplitude(scene);
    if (!found.form) continue;
    std::map<std::string, double> names;
    for (const auto& [symbol, value] : scene.elements) names[to_text(symbol)] = *value;
    for (const Quantity& quantity : quantities(scene))
      if (quantity.value) names[to_text(quantity.symbol)] = *quantity.value;
    for (const auto& each : found.form->definitions)
      names[each.name.text] = test::value_of(each.meaning, names);
    const double bound = test::value_of(found.form->velocity, names);
    for (const double factor : {1 - 1e-10, 1 + 1e-10}) {
      scene.amplitude.value = bound * factor;
      BOOST_TEST(opens(scene) == (factor > 1), "scene " << i);
    }
    ++compared;
  }
  BOOST_TEST(compared > 40);
}

BOOST_AUTO_TEST_CASE(names_are_listed_as_people_do) {
  const Scene scene = scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = 0.3");
  BOOST_TEST(listed({{"k0"}, {"k", 1}, {"k", 2}, {"k", 3}, {"tau", 2}}, scene).text() ==
             "k0, k and tau[2]");
  BOOST_TEST(listed({{"k0"}}, scene).text() == "k0");
}

BOOST_AUTO_TEST_SUITE_END()
