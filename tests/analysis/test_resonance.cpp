// Resonances: closed forms make the condition vanish in an independent nodal evaluation; damped
// conditions have its real and imaginary part.
#include <boost/test/unit_test.hpp>

#include "analysis/resonance.hpp"
#include "derivation/scenes.hpp"
#include "derivation/values.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"
#include "support/nodal.hpp"

BOOST_AUTO_TEST_SUITE(test_resonance)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

constexpr double ratio = 0.75;  // of isotropic scenes here

/// Doubles of one size for all symbols.
Values values_for(const Scene& scene) {
  Values values{{{"m"}, 0.625}, {{"omega"}, 1.75}};
  double next = 1;
  for (const auto& [symbol, value] : scene.elements) values[symbol] = next += 0.375;
  return values;
}

test::ExactValues exact(const Values& values) {
  test::ExactValues result;
  for (const auto& [symbol, value] : values) result[symbol] = exact_binary(value);
  return result;
}

test::Complex condition(const Scene& scene, Resonance::Kind kind, const Values& values,
                        const test::Real& omega) {
  test::Nodal nodal(values, omega);
  test::Complex k = nodal.stiffness(*scene.drive);
  if (kind == Resonance::Kind::antiresonance) {
    const auto* tangential = std::get_if<Network>(&scene.tangential);
    k += tangential != nullptr ? nodal.stiffness(*tangential)
                               : nodal.stiffness(scene.normal) * test::Complex(ratio);
  }
  return k - test::Complex(test::Real(values.at({"m"})) * omega * omega);
}

test::Real number(const GiNaC::numeric& value) {
  std::ostringstream digits;
  digits << value;
  return test::Real(digits.str());
}

// At 60 digits: the root and a dozen operations of the closed form leave more than 50, of which
// omega^2 keeps all but one.
void check_closed_forms(const Scene& scene) {
  const std::vector<Resonance> all = resonances(derive(scene));
  BOOST_REQUIRE(all.size() == 2u);
  const Values values = values_for(scene);
  for (const Resonance& resonance : all) {
    BOOST_TEST(!resonance.damped);
    BOOST_REQUIRE(resonance.frequency.has_value());
    const test::Real omega =
        number(value_at(*resonance.frequency, resonance.definitions, exact(values)));
    const test::Real inertia = test::Real(values.at({"m"})) * omega * omega;
    const test::Real left = abs(condition(scene, resonance.kind, values, omega));
    BOOST_TEST((left / inertia < test::Real("1e-45")));
  }
}

// Both parts times one positive number: the quotients of found and expected parts agree.
void check_parts(const Scene& scene, const Resonance& resonance) {
  BOOST_TEST(resonance.damped);
  BOOST_TEST(!resonance.frequency.has_value());
  BOOST_REQUIRE(resonance.parts.has_value());
  const Values values = values_for(scene);
  const test::Complex expected =
      condition(scene, resonance.kind, values, test::Real(values.at({"omega"})));
  const test::Real re = number(value_at(resonance.parts->real, {}, exact(values)));
  const test::Real im = number(value_at(resonance.parts->imaginary, {}, exact(values)));
  const test::Real scale = im / test::Real(expected.imag());
  BOOST_TEST((scale > 0));
  BOOST_TEST((abs(re - scale * test::Real(expected.real())) < abs(re) * test::Real("1e-45")));
}

const std::string spring_graph =
    "[networks.mesh]\nterminals = [\"a\", \"b\"]\n"
    "edges = [[\"k1\", \"a\", \"1\"], [\"k2\", \"a\", \"2\"], [\"k3\", \"1\", \"2\"], "
    "[\"k4\", \"1\", \"b\"], [\"k5\", \"2\", \"b\"], [\"k6\", \"2\", \"3\"], [\"k7\", \"3\", "
    "\"b\"], [\"k8\", \"1\", \"3\"]]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(closed_forms_without_dampers) {
  GiNaC::Digits = 60;
  const auto all = resonances(derive(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m")));
  BOOST_TEST(to_text(all[0].condition) == "K_d - m*omega^2");
  BOOST_TEST(to_text(*all[0].frequency) == "sqrt(kd/m)");
  BOOST_TEST(to_text(all[1].condition) == "K_d + K_t - m*omega^2");
  BOOST_TEST(to_text(*all[1].frequency) == "sqrt((kd + kt)/m)");
  check_closed_forms(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m"));
  check_closed_forms(
      scene_of("normal = \"k1 | k2 - k3\"\ntangential_ratio = 0.75", "k4 - k5", "m"));
  // A graph too large to be multiplied out.
  const Scene mesh =
      scene_of("normal = \"mesh\"\ntangential_ratio = 0.75", "kd", "m", spring_graph);
  BOOST_TEST(!resonances(derive(mesh))[1].definitions.empty());
  check_closed_forms(mesh);
}

BOOST_AUTO_TEST_CASE(isotropic_and_equal_networks_are_put_together) {
  const auto isotropic =
      resonances(derive(scene_of("normal = \"kn\"\npoisson = \"nu\"", "kd", "m")));
  BOOST_TEST(to_text(isotropic[1].condition) == "K_d + 2*K_n*(1 - nu)/(2 - nu) - m*omega^2");
  const auto equal = resonances(derive(scene_of("normal = \"k\"\ntangential = \"k\"", "k", "m")));
  BOOST_TEST(to_text(equal[1].condition) == "2*K_n - m*omega^2");
  GiNaC::Digits = 60;
  check_closed_forms(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kt", "m"));
}

BOOST_AUTO_TEST_CASE(dampers_keep_the_condition_away_from_zero) {
  GiNaC::Digits = 60;
  const auto both = [](const Scene& scene) {
    for (const Resonance& resonance : resonances(derive(scene))) check_parts(scene, resonance);
  };
  both(scene_of("normal = \"kn | cn\"\ntangential = \"kt | ct\"", "kd | cd", "m"));
  both(scene_of("normal = \"k0 | (k1 - c1)\"\ntangential_ratio = 0.75", "kd | cd", "m"));
  both(scene_of("normal = \"kn\"\ntangential = \"k1 - c1\"", "kd - cd", "m"));
  // A damped contact under an elastic drive resonates all the same.
  const auto all = resonances(derive(test::kelvin_scene()));
  BOOST_TEST(to_text(*all[0].frequency) == "sqrt(kd/m)");
  check_parts(test::kelvin_scene(), all[1]);
  BOOST_TEST(to_text(all[1].parts->real) == "kd + kt - m*omega^2");
  BOOST_TEST(to_text(all[1].parts->imaginary) == "omega*ct");
}

BOOST_AUTO_TEST_CASE(large_damped_conditions_are_not_multiplied_out) {
  const auto all = resonances(
      derive(scene_of("normal = \"prony(k0, k, tau, 12)\"\ntangential_ratio = 0.75", "kd", "m")));
  BOOST_TEST(all[0].frequency.has_value());
  BOOST_TEST(all[1].damped);
  BOOST_TEST(!all[1].parts.has_value());
}

// Along the normal, beside those along the surface, with the body's mass or one of its own.
BOOST_AUTO_TEST_CASE(a_mount_resonates_with_the_contact) {
  using Kind = Resonance::Kind;
  const std::string elastic = "normal = \"kn\"\ntangential = \"kt\"",
                    shared = "[mount]\nnetwork = \"km\"\nmass = \"m\"\n";
  const auto all = resonances(derive(scene_of(elastic, "kd", "m", shared)));
  BOOST_REQUIRE(all.size() == 3U);
  BOOST_TEST((all[0].kind == Kind::resonance && all[1].kind == Kind::antiresonance));
  BOOST_TEST((all[2].kind == Kind::mount_resonance));
  BOOST_TEST(to_text(all[0].condition) == "K_d - m*omega^2");
  BOOST_TEST(to_text(all[2].condition) == "K_m + K_n - m*omega^2");
  BOOST_TEST(to_text(*all[2].frequency) == "sqrt((km + kn)/m)");
  const auto damped = resonances(derive(
      scene_of(test::kelvin_contact, "", "", "[mount]\nnetwork = \"km\"\nmass = \"m_n\"\n")));
  BOOST_REQUIRE(damped.size() == 1U);
  BOOST_TEST(damped[0].damped);
  BOOST_TEST(to_text(damped[0].parts->real) == "km + kn - m_n*omega^2");
  BOOST_TEST(to_text(damped[0].parts->imaginary) == "omega*cn");
  BOOST_TEST(
      resonances(derive(scene_of(elastic, "kd", "", "[mount]\nnetwork = \"km\"\n"))).empty());
}

BOOST_AUTO_TEST_CASE(without_a_mass_nothing_resonates) {
  BOOST_TEST(resonances(derive(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd"))).empty());
  BOOST_TEST(resonances(derive(scene_of(test::kelvin_contact))).empty());
}

BOOST_AUTO_TEST_SUITE_END()
