// v*^2 multiplied out: its value, its size known beforehand, its extrema, its lines.
#include <boost/test/unit_test.hpp>

#include "analysis/exact_scene.hpp"
#include "analysis/rational_form.hpp"
#include "analysis/rational_lines.hpp"
#include "derivation/scenes.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"

BOOST_AUTO_TEST_SUITE(test_rational_form)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

RationalForm form_of(const Scene& scene) { return rational_form(SymbolicModel(scene), 1e5); }

/// v*^2 of the lines, from the last to the first.
GiNaC::numeric square(const std::vector<Line>& lines, const Scene& scene) {
  const std::vector<Line> definitions(lines.rbegin(), lines.rend() - 1);
  return value_at(lines.front().right, definitions, test::exact_values(scene));
}

std::vector<std::string> texts(const Scene& scene) {
  std::vector<std::string> result;
  for (const Line& line : lines_of(form_of(scene)))
    result.push_back(to_text(line.left) + " = " + to_text(line.right));
  return result;
}

}  // namespace

// Expected by hand from (24), squared.
BOOST_AUTO_TEST_CASE(small_scenes_read_well) {
  using Texts = std::vector<std::string>;
  BOOST_TEST((texts(test::scene_of("normal = \"kn\"\ntangential = \"kt\"")) ==
              Texts{"v*^2 = mu0^2*omega^2*du_z^2*kn^2/kt^2"}));
  BOOST_TEST((texts(test::scene_of("normal = \"k | c\"\npoisson = 0.3")) ==
              Texts{"v*^2 = 289/196*mu0^2*omega^2*du_z^2"}));
  BOOST_TEST((texts(test::scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m")) ==
              Texts{"v*^2 = mu0^2*omega^2*du_z^2*kn^2*(kd + kt - m*omega^2)^2/"
                    "(kt^2*(kd - m*omega^2)^2)"}));
  // Maxwell against Kelvin: |K_n|^2 = k1^2 c1^2 w^2/(k1^2 + c1^2 w^2), |K_t|^2 = k2^2 + c2^2 w^2.
  BOOST_TEST((texts(test::scene_of("normal = \"k1 - c1\"\ntangential = \"k2 | c2\"")) ==
              Texts{"v*^2 = mu0^2*omega^4*du_z^2*c1^2*k1^2/"
                    "((k1^2 + c1^2*omega^2)*(k2^2 + c2^2*omega^2))"}));
}

// (24) of a Zener contact with g = 17/14: K = k0 + i w c1 k1/(k1 + i w c1), D = Z.
BOOST_AUTO_TEST_CASE(coefficients_are_factored_in_the_shortest_variables) {
  using Texts = std::vector<std::string>;
  const Scene zener = test::scene_of("normal = \"zener(k0, k1, c1)\"\npoisson = 0.3", "kd", "m");
  Texts found;
  for (const Line& line : lines_of(form_of(zener), swinging(zener)))
    found.push_back(to_text(line.left) + " = " + to_text(line.right));
  BOOST_TEST(
      (found == Texts{"v*^2 = mu0^2*omega^2*du_z^2*N/(196*Z^2*(k1^2 + c1^2*omega^2))",
                      "Z = kd - m*omega^2", "N = n_0 + n_2*omega^2", "n_0 = k1^2*(14*k0 + 17*Z)^2",
                      "n_2 = c1^2*(14*k0 + 14*k1 + 17*Z)^2"}));
  // As documents have it: with the ratio by its name.
  found.clear();
  const RationalForm named = rational_form(SymbolicModel(zener), 100, in_ratio(zener));
  for (const Line& line : lines_of(named, swinging(zener)))
    found.push_back(to_text(line.left) + " = " + to_text(line.right));
  BOOST_TEST((found == Texts{"v*^2 = mu0^2*omega^2*du_z^2*N/(Z^2*(k1^2 + c1^2*omega^2))",
                             "Z = kd - m*omega^2", "N = n_0 + n_2*omega^2",
                             "n_0 = k1^2*(k0 + g*Z)^2", "n_2 = c1^2*(k0 + k1 + g*Z)^2"}));
  BOOST_TEST(to_text(ratio_line(zener)->right) == "17/14");
}

// v*^2 of springs and a mass is w^2 (kt + Z)^2/Z^2 up to a factor, Z = kd - m w^2: extrema at kt +
// Z = 0 and where kt Z + Z^2 + 2 kt m w^2 = 0.
BOOST_AUTO_TEST_CASE(extrema_are_factored_without_the_trivial_root) {
  const Scene elastic = test::scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m");
  const RationalForm form = form_of(elastic);
  const std::vector<Line> lines = extrema_lines_of(form, swinging(elastic));
  BOOST_TEST(lines.front().right.is_zero());
  for (const auto& [omega_squared, is_root] :
       std::vector<std::pair<GiNaC::ex, bool>>{{5, true}, {3, false}, {0, false}}) {
    // kd = 2, kt = 3, m = 1: w^2 = 5, and w^4 - w^2 + 10 = 0 nowhere.
    GiNaC::exmap at{{symbol({"kd"}), 2},
                    {symbol({"kt"}), 3},
                    {symbol({"m"}), 1},
                    {omega(), GiNaC::sqrt(omega_squared)}};
    GiNaC::ex left = lines.front().left;
    for (auto line = lines.rbegin(); line + 1 != lines.rend(); ++line)
      left = left.subs(line->left == line->right);
    BOOST_TEST(left.subs(at).expand().is_zero() == is_root);
  }
  // k1 against a Kelvin contact: v* grows throughout.
  const Scene monotonic = test::scene_of("normal = \"k1\"\ntangential = \"k2 | c2\"");
  const RationalForm of_monotonic = form_of(monotonic);
  BOOST_TEST(extrema_lines_of(of_monotonic, swinging(monotonic)).empty());
}

// w^2 ((c2 + c3 + c4)^2 + m^2 w^2)/(c4^2 + m^2 w^2) grows throughout: no coefficient is negative.
BOOST_AUTO_TEST_CASE(an_equation_without_roots_is_not_shown) {
  const Scene dampers = test::scene_of("normal = \"c1\"\ntangential = \"c2 | c3\"", "c4", "m");
  const RationalForm form = form_of(dampers);
  BOOST_TEST(stationary(form).degree("omega") > 0U);
  BOOST_TEST(extrema_lines_of(form).empty());
}

// K_n + g Z in place of 2 (1 - nu) K_n + (2 - nu) Z.
BOOST_AUTO_TEST_CASE(poissons_ratio_is_in_the_ratio_of_the_stiffnesses) {
  const Scene scene = test::scene_of("normal = \"k0\"\npoisson = \"nu\"", "kd", "m");
  const RationalForm form = rational_form(SymbolicModel(scene), 100, in_ratio(scene));
  BOOST_TEST(to_text(lines_of(form, swinging(scene)).front().right) ==
             "mu0^2*omega^2*du_z^2*(k0 + g*Z)^2/Z^2");
  BOOST_TEST(!ratio_line(test::scene_of("normal = \"k0\"\npoisson = 0.3")));
}

BOOST_AUTO_TEST_CASE(who_swings_on_which_spring) {
  const auto of = [](const char* drive, const char* mass) {
    return swinging(test::scene_of("normal = \"kn\"\ntangential = \"kt\"", drive, mass));
  };
  BOOST_TEST(of("kd | cd", "m").value().spring == "kd");
  BOOST_TEST(!of("kd | k2", "m"));
  BOOST_TEST(!of("cd", "m"));
  BOOST_TEST(!of("kd", ""));
}

BOOST_AUTO_TEST_CASE(values_are_those_of_the_nodes) {
  GiNaC::Digits = 200;
  test::RandomScenes random(20261122, 3);
  int compared = 0;
  for (int i = 0; i < 120; ++i) {
    Scene scene = random.scene(i % 6 + 1);
    test::round_ratio(scene);
    const SymbolicModel model(scene);
    if (terms_before_squaring(model) > 2000) continue;
    ++compared;
    const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
    // Some 1e5 terms over 6 decades each in up to 20 factors: 140 of 200 digits may be lost.
    BOOST_TEST(
        test::agreement(square(lines_of(rational_form(model, 2000)), scene), nodal * nodal) > 50,
        "scene " << i);
  }
  BOOST_TEST(compared > 60);
}

BOOST_AUTO_TEST_CASE(masses_of_the_drive_are_multiplied_out) {
  GiNaC::Digits = 200;
  Scene scene = read_scene(VCRIT_SCENES "/sonotrode.toml");
  test::round_ratio(scene);
  const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
  BOOST_TEST(test::agreement(square(lines_of(form_of(scene)), scene), nodal * nodal) > 50);
}

// Of numbers for all symbols the form is that of omega alone.
BOOST_AUTO_TEST_CASE(with_values_put_in) {
  GiNaC::Digits = 200;
  test::RandomScenes random(7, 2);
  for (int i = 0; i < 60; ++i) {
    Scene scene = random.scene(i % 12 + 1);
    test::round_ratio(scene);
    std::map<std::string, GiNaC::numeric> values;
    for (const auto& [symbol, value] : test::exact_values(scene))
      if (symbol.name != "omega") values[to_text(symbol)] = value;
    const std::vector<Line> lines = lines_of(rational_form(SymbolicModel(scene), values));
    const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
    BOOST_TEST(test::agreement(square(lines, scene), nodal * nodal) > 50, "scene " << i);
  }
}

BOOST_AUTO_TEST_CASE(too_many_terms_are_refused_before_they_are_made) {
  // K of 60 Maxwell branches has 2^60 + 60 2^59 = 3.6e19 terms: nobody would live to see them.
  const Scene scene = test::scene_of("normal = \"prony(k0, k, tau, 60)\"\ntangential = \"kt\"");
  BOOST_CHECK_EXCEPTION(rational_form(SymbolicModel(scene), 5000), ModelError,
                        [](const ModelError& e) {
                          return std::string(e.what()).find("3.5740") != std::string::npos ||
                                 std::string(e.what()).find("e+19") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(one_function_has_one_text) {
  const auto text = [](const std::string& normal) {
    return canonical_text(form_of(
        test::scene_of("normal = \"" + normal + "\"\ntangential = \"kt\"", "kd | cd", "m")));
  };
  BOOST_TEST(text("k0 | (k1 - c1)") == text("(c1 - k1) | k0"));
  BOOST_TEST(text("(k1 - c1) | (k1 - c1)") == text("(k1 | k1) - (c1 | c1)"));
  BOOST_TEST(text("k0 | (k1 - c1)") != text("k1 | (k0 - c1)"));
}

// d/dw of w^2/(k^2 + c^2 w^2)^2 ... by hand: v*^2 = w^2 k1^2/(k2^2 + c2^2 w^2) grows throughout;
// a Maxwell normal contact of v*^2 = w^4 .../((k1^2 + c1^2 w^2)(k2^2 + c2^2 w^2)) does, too; with
// an elastic drive and a mass the extrema are where (13), (19) say.
BOOST_AUTO_TEST_CASE(extrema) {
  const RationalForm of_kelvin =
      form_of(test::scene_of("normal = \"k1\"\ntangential = \"k2 | c2\""));
  const Polynomial kelvin = stationary(of_kelvin);
  BOOST_TEST(kelvin.degree("omega") == 0U);
  const RationalForm of_elastic = form_of(test::scene_of("normal = \"k1\"\ntangential = \"k2\""));
  const Polynomial constant = stationary(of_elastic);
  BOOST_TEST(constant.degree("omega") == 0U);
  // v* = w |k - m w^2|/|kd - m w^2| up to a factor, k = kt + kd: the derivative of its square is 0
  // at w^2 = k/m and where (k - 3 m w^2)(kd - m w^2) + 2 m w^2 (k - m w^2) = 0.
  const Scene elastic = test::scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m");
  const RationalForm form = form_of(elastic);
  const Polynomial found = stationary(form);
  const Ring& ring = found.ring();
  const auto v = [&ring](const char* name) { return Polynomial::variable(ring, name); };
  const Polynomial w2 = Polynomial::power(ring, "omega", 2), k = v("kt") + v("kd");
  const auto times = [&ring](long n) { return Polynomial(ring, n); };
  const Polynomial expected =
      (k - v("m") * w2) * ((k - times(3) * v("m") * w2) * (v("kd") - v("m") * w2) +
                           times(2) * v("m") * w2 * (k - v("m") * w2));
  BOOST_TEST((found == expected.primitive("omega")));
}

BOOST_AUTO_TEST_SUITE_END()
