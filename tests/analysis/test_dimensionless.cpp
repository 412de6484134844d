// Dimensionless groups: their v* is v*, whatever the units.
#include <boost/test/unit_test.hpp>

#include "analysis/dimensionless.hpp"
#include "analysis/exact_scene.hpp"
#include "derivation/scenes.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"

BOOST_AUTO_TEST_SUITE(test_dimensionless)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

std::vector<std::string> groups(const DimensionlessForm& form) {
  std::vector<std::string> result;
  for (const Line& line : form.groups)
    result.push_back(to_text(line.left) + " = " + to_text(line.right));
  return result;
}

/// mu0 omega du_z times the form at the groups' values.
GiNaC::numeric velocity(const DimensionlessForm& form, const Scene& scene) {
  const auto values = test::exact_values(scene);
  std::vector<Line> known;
  for (const Line& line : form.groups)
    known.push_back({"", line.left, value_at(line.right, {}, values)});
  known.insert(known.end(), form.definitions.begin(), form.definitions.end());
  return value_at(form.velocity, known, {}) * values.at({"mu0"}) * values.at({"omega"}) *
         values.at({"du_z"});
}

}  // namespace

BOOST_AUTO_TEST_CASE(groups_are_those_one_would_write) {
  using Texts = std::vector<std::string>;
  const DimensionlessForm zener = dimensionless(
      derive(test::scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt\"", "kd | cd", "m")));
  BOOST_TEST((groups(zener) == Texts{"kappa_k1 = k1/k0", "theta_c1 = omega*c1/k1",
                                     "kappa_kt = kt/k0", "kappa_kd = kd/k0",
                                     "theta_cd = omega*cd/kd", "beta_m = m*omega^2/kd"}));
  const DimensionlessForm prony = dimensionless(
      derive(test::scene_of("normal = \"prony(k0, k, tau, 1)\"\ntangential = \"kt\"")));
  BOOST_TEST((groups(prony) ==
              Texts{"kappa_k[1] = k[1]/k0", "theta_tau[1] = omega*tau[1]", "kappa_kt = kt/k0"}));
}

// |K_n|/k = |1 + i theta| and |K_t|/k = kappa
BOOST_AUTO_TEST_CASE(kelvin_by_hand) {
  const DimensionlessForm form =
      dimensionless(derive(test::scene_of("normal = \"kn | cn\"\ntangential = \"kt\"")));
  BOOST_TEST(to_text(form.velocity) == "sqrt(1 + theta_cn^2)/kappa_kt");
}

BOOST_AUTO_TEST_CASE(what_cancels_has_no_group) {
  const DimensionlessForm form =
      dimensionless(derive(test::scene_of("normal = \"k0 | (k1 - c1)\"\ntangential_ratio = 0.8")));
  BOOST_TEST(form.groups.empty());
  BOOST_TEST(to_text(form.velocity) == "5/4");
}

// The damper's group is theta_c1, as is the name of the spring that all refers to.
BOOST_AUTO_TEST_CASE(a_group_is_no_element_of_its_name) {
  const Scene renamed =
      test::scene_of("normal = \"spring(theta_c1) | (k1 - c1)\"\ntangential = \"kt\"", "kd", "m");
  const DimensionlessForm form = dimensionless(derive(renamed));
  for (const Line& line : form.groups)
    for (const auto& [element, value] : renamed.elements)
      BOOST_TEST(!line.left.is_equal(symbolic::symbol(element)), to_text(element));
  const NamesOfScene names(renamed);
  BOOST_TEST(groups(form).at(1) == "theta_c1_own = omega*c1/k1");
}

BOOST_AUTO_TEST_CASE(masses_of_the_drive_have_groups) {
  GiNaC::Digits = 150;
  Scene scene = read_scene(VCRIT_SCENES "/sonotrode.toml");
  test::round_ratio(scene);
  const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
  BOOST_TEST(test::agreement(velocity(dimensionless(derive(scene)), scene), nodal) > 50);
}

BOOST_AUTO_TEST_CASE(values_are_those_of_the_nodes) {
  GiNaC::Digits = 150;
  test::RandomScenes random(20261123, 4);
  int nested = 0, without_springs = 0;
  for (int i = 0; i < 150; ++i) {
    Scene scene = random.scene(i % 12 + 1);
    test::round_ratio(scene);
    const DimensionlessForm form = dimensionless(derive(scene));
    nested += form.definitions.empty() ? 0 : 1;
    const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
    // As in the derivation's own test: some 24*8/2 of 150 digits are lost at most.
    BOOST_TEST(test::agreement(velocity(form, scene), nodal) > 50, "scene " << i);
    for (const Line& line : form.definitions)
      for (const auto& [symbol, value] : scene.elements)
        BOOST_TEST(!line.right.has(symbolic::symbol(symbol)), to_text(symbol));
    bool spring = false;
    for (const auto& [symbol, value] : scene.elements) spring = spring || symbol.name[0] == 'k';
    without_springs += spring ? 0 : 1;
  }
  BOOST_TEST(nested > 10);
  BOOST_TEST(without_springs > 0);
}

BOOST_AUTO_TEST_SUITE_END()
