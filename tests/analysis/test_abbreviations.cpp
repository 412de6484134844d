// g = K_n/K_t and Z = k_d - m omega^2 in limits, asymptotes and conditions of resonance: what an
// expert writes, by hand from (24), |K_n + g (K_d - m omega^2)|/|K_d - m omega^2|.
#include <boost/test/unit_test.hpp>

#include <map>
#include <string>

#include "analysis/abbreviations.hpp"
#include "analysis/asymptotes.hpp"
#include "analysis/limits.hpp"
#include "analysis/resonance.hpp"
#include "analysis/sensitivities.hpp"
#include "derivation/scenes.hpp"
#include "derivation/values.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"

BOOST_AUTO_TEST_SUITE(test_abbreviations)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;
using Texts = std::vector<std::string>;

namespace {

Texts lines(const std::vector<Line>& of) {
  Texts result;
  for (const Line& line : of) result.push_back(to_text(line.left) + " = " + to_text(line.right));
  return result;
}

/// Names that are used, then the limits.
Texts limits_of(const Scene& scene) {
  const Derivation derivation = derive(scene);
  const Abbreviations names = abbreviations(derivation);
  std::vector<GiNaC::ex> shown;
  Texts result;
  for (const Limit& limit : limits(derivation, names)) {
    shown.push_back(limit.shown);
    result.push_back(limit.name + ": " + to_text(limit.shown));
  }
  Texts all = lines(names.used_by(shown));
  all.insert(all.end(), result.begin(), result.end());
  return all;
}

const std::string zener = "normal = \"k0 | (k1 - c1)\"\n";

}  // namespace

BOOST_AUTO_TEST_CASE(limits_have_the_ratio_and_the_stiffness_by_name) {
  const std::string front = "mu0*omega*du_z*";
  const Texts expected{
      "Z = kd - m*omega^2",
      "kd -> infinity: " + front + "g",
      "m -> 0: " + front +
          "sqrt((k1^2*(k0 + g*kd)^2 + c1^2*omega^2*(k0 + k1 + g*kd)^2)/(k1^2 + c1^2*omega^2))/kd",
      "k1 -> 0: " + front + "abs(k0 + g*Z)/abs(Z)",
      "k1 -> infinity: " + front + "sqrt((k0 + g*Z)^2 + c1^2*omega^2)/abs(Z)",
      "c1 -> 0: " + front + "abs(k0 + g*Z)/abs(Z)",
      "c1 -> infinity: " + front + "abs(k0 + k1 + g*Z)/abs(Z)",
      "c1 -> 0, kd -> infinity: " + front + "g"};
  for (const auto& [ratio, meaning] : {std::pair("poisson = 0.3", "g = 17/14"),
                                       {"poisson = \"nu\"", "g = (2 - nu)/(2*(1 - nu))"},
                                       {"tangential_ratio = 0.8", "g = 5/4"}}) {
    Texts with_ratio = expected;
    with_ratio.insert(with_ratio.begin(), meaning);
    BOOST_TEST(limits_of(scene_of(zener + ratio, "kd", "m")) == with_ratio,
               boost::test_tools::per_element());
  }
}

// Ten branches stay in complex stiffnesses.
BOOST_AUTO_TEST_CASE(nested_limits_have_the_ratio_by_name) {
  const Derivation derivation =
      derive(scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.3", "kd", "m"));
  const std::vector<Limit> all = limits(derivation, abbreviations(derivation));
  BOOST_TEST(to_text(all.at(1).shown) == "mu0*omega*du_z*abs(K_n + g*K_d)/abs(K_d)");
  BOOST_TEST(to_text(all.at(1).result) == "mu0*omega*du_z*abs(14*K_n + 17*K_d)/(14*abs(K_d))");
}

BOOST_AUTO_TEST_CASE(names_that_say_nothing_are_left_out) {
  const auto names = [](const Scene& scene) {
    const Abbreviations found = abbreviations(derive(scene));
    return std::pair(found.ratio.has_value(), found.stiffness.has_value());
  };
  // K_t = K_n, a ratio with a name, a tangential network; no drive, no mass, two springs.
  BOOST_TEST(
      (names(scene_of(zener + "tangential_ratio = 1", "kd", "m")) == std::pair(false, true)));
  BOOST_TEST(
      (names(scene_of(zener + "tangential_ratio = \"r\"", "kd")) == std::pair(false, false)));
  BOOST_TEST((names(scene_of(zener + "tangential = \"kt\"", "kd", "m")) == std::pair(false, true)));
  BOOST_TEST((names(scene_of(zener + "poisson = 0.3")) == std::pair(false, false)));
  BOOST_TEST((names(scene_of(zener + "poisson = 0.3", "kd - ks", "m")) == std::pair(true, false)));
}

BOOST_AUTO_TEST_CASE(asymptotes_have_the_ratio_by_name) {
  const Derivation derivation = derive(scene_of(zener + "poisson = 0.3", "kd", "m"));
  const auto found = asymptotes(derivation, abbreviations(derivation));
  BOOST_TEST(to_text(found.at(0).coefficient) == "mu0*du_z*(k0 + g*kd)/kd");
  BOOST_TEST(to_text(found.at(1).coefficient) == "mu0*du_z*g");
  // Without names they are numbers, as JSON has them.
  BOOST_TEST(to_text(asymptotes(derivation).at(1).coefficient) == "17/14*mu0*du_z");
}

// K_n + g Z = 0 with K_n = k0 + k1 i w c1/(k1 + i w c1), times |k1 + i w c1|^2.
BOOST_AUTO_TEST_CASE(conditions_of_resonance_have_both) {
  const Derivation derivation = derive(scene_of(zener + "poisson = 0.3", "kd", "m"));
  const auto found = resonances(derivation, abbreviations(derivation));
  BOOST_TEST_REQUIRE(found.size() == 2U);
  BOOST_TEST(to_text(found[0].condition) == "K_d - m*omega^2");
  BOOST_TEST(to_text(found[1].condition) == "K_n + g*(K_d - m*omega^2)");
  BOOST_TEST_REQUIRE(found[1].parts.has_value());
  const GiNaC::ex k0 = symbol({"k0"}), k1 = symbol({"k1"}), c1 = symbol({"c1"}),
                  g = positive_quantity("g"), Z = real_quantity("Z");
  const GiNaC::ex turn = GiNaC::pow(omega() * c1, 2);
  BOOST_TEST((found[1].parts->real - k1 * k1 * (k0 + g * Z) - turn * (k0 + k1 + g * Z))
                 .expand()
                 .is_zero());
  BOOST_TEST(to_text(found[1].parts->real) == "k1^2*(k0 + g*Z) + c1^2*omega^2*(k0 + k1 + g*Z)");
  BOOST_TEST(to_text(found[1].parts->imaginary) == "omega*c1*k1^2");
  // Where the drive is the contact's network, both conditions have that alone.
  const Derivation same = derive(scene_of("normal = \"k0 | c0\"\npoisson = 0.3", "k0 | c0", "m"));
  const auto of_one = resonances(same, abbreviations(same));
  BOOST_TEST_REQUIRE(of_one.size() == 2U);
  BOOST_TEST(to_text(of_one[0].condition) == "K_n - m*omega^2");
  BOOST_TEST(to_text(of_one[1].condition) == "K_n + g*(K_n - m*omega^2)");
}

// By hand: with K_n = k0 the condition k0 + g (kd - m omega^2) = 0 gives omega.
BOOST_AUTO_TEST_CASE(the_antiresonance_has_the_ratio_by_name) {
  for (const char* ratio : {"poisson = 0.3", "poisson = \"nu\"", "tangential_ratio = 0.8"}) {
    const Derivation derivation =
        derive(scene_of(std::string("normal = \"k0\"\n") + ratio, "kd", "m"));
    const auto found = resonances(derivation, abbreviations(derivation));
    BOOST_TEST_REQUIRE(found.size() == 2U);
    BOOST_TEST(to_text(found[0].frequency.value()) == "sqrt(kd/m)");
    BOOST_TEST(to_text(found[1].frequency.value()) == "sqrt((k0 + g*kd)/(g*m))");
  }
  const Derivation plain = derive(scene_of("normal = \"k0\"\npoisson = 0.3", "kd", "m"));
  BOOST_TEST(to_text(resonances(plain)[1].frequency.value()) == "sqrt(14*k0/(17*m) + kd/m)");
}

// By hand: ln v* = ln|k0 + g Z| - ln|Z| and what k0, kd, m and nu are not in. dZ/dm = -omega^2,
// (nu/g) dg/dnu = nu/((1 - nu) (2 - nu)), and g d/dg ln v* = g Z/(k0 + g Z).
BOOST_AUTO_TEST_CASE(sensitivities_have_both) {
  const Derivation derivation = derive(scene_of("normal = \"k0\"\npoisson = \"nu\"", "kd", "m"));
  const auto all = sensitivities(derivation, abbreviations(derivation)).each;
  std::map<std::string, std::string> found;
  for (const Sensitivity& each : all) found[to_text(each.parameter)] = to_text(each.relative);
  BOOST_TEST(found["k0"] == "k0/(k0 + g*Z)");
  BOOST_TEST(found["m"] == "k0*m*omega^2/(Z*(k0 + g*Z))");
  BOOST_TEST(found["kd"] == "-k0*kd/(Z*(k0 + g*Z))");
  BOOST_TEST(found["nu"] == "g*nu*Z/((1 - nu)*(2 - nu)*(k0 + g*Z))");
}

BOOST_AUTO_TEST_SUITE_END()
