// The paper's equations come out of the derivation by symbolic equality. The right-hand sides here
// are typed from the paper; the derivation does not know them.
#include <boost/test/unit_test.hpp>

#include "analysis/limits.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "document/print.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"

BOOST_AUTO_TEST_SUITE(test_equations)

using namespace vcrit;
using namespace vcrit::symbolic;
using GiNaC::ex;

namespace {

ex sym(const char* name) { return symbol({name}); }

const ex mu0 = sym("mu0"), w = sym("omega"), du_z = sym("du_z"), m = sym("m");
const ex kn = sym("kn"), cn = sym("cn"), kt = sym("kt"), ct = sym("ct"), kd = sym("kd");

/// Takes absolute values off: in a square they do not matter.
struct WithoutAbs : GiNaC::map_function {
  ex operator()(const ex& e) override {
    if (GiNaC::is_a<GiNaC::function>(e)) return e.op(0).map(*this);
    return e.map(*this);
  }
};

/// Both formulas are positive, so that equal squares make them equal.
bool equal(const ex& a, const ex& b) {
  WithoutAbs without_abs;
  return (without_abs(GiNaC::pow(a, 2)) - without_abs(GiNaC::pow(b, 2))).normal().is_zero();
}

const Limit& limit(const std::vector<Limit>& all, const std::string& equation) {
  for (const Limit& each : all)
    if (each.equation == equation) return each;
  throw std::runtime_error("no limit " + equation);
}

const ex eq30 =
    mu0 * w * du_z * kn / kt * GiNaC::abs(kt + kd - m * w * w) / GiNaC::abs(kd - m * w * w);
const ex eq31 = mu0 * w * du_z * kn / kt;

}  // namespace

BOOST_AUTO_TEST_CASE(equality_is_not_always_true) {
  BOOST_TEST(!equal(eq30, eq31));
  BOOST_TEST(equal(eq31, eq31 * (kd + m) / (m + kd)));
}

BOOST_AUTO_TEST_CASE(kelvin_contact_under_an_elastic_drive_is_27) {
  const Derivation derivation = derive(test::kelvin_scene());
  const auto size = [](const ex& re, const ex& im) { return GiNaC::sqrt(re * re + im * im); };
  const ex D = kd - m * w * w;
  const ex eq27 =
      mu0 * w * du_z * size(kn, w * cn) / size(kt, w * ct) * size(kt + D, w * ct) / GiNaC::abs(D);
  BOOST_TEST(equal(derivation.critical_velocity, eq27));
  BOOST_TEST(derivation.equation == "(27)");
}

BOOST_AUTO_TEST_CASE(limits_29_30_31) {
  const std::vector<Limit> all = limits(derive(test::kelvin_scene()));
  const ex eq29 = mu0 * w * du_z / GiNaC::abs(kd - m * w * w) *
                  GiNaC::sqrt(GiNaC::pow(w * cn, 2) +
                              GiNaC::pow(kn / kt, 2) * GiNaC::pow(kt + kd - m * w * w, 2));
  BOOST_TEST(equal(limit(all, "(29)").result, eq29));
  BOOST_TEST(equal(limit(all, "(30)").result, eq30));
  BOOST_TEST(equal(limit(all, "(31)").result, eq31));
}

BOOST_AUTO_TEST_CASE(isotropy_declared_by_a_ratio_gives_29_itself) {
  const Scene scene = test::scene_of("normal = \"kn | cn\"\ntangential_ratio = \"r\"", "kd", "m");
  const Derivation derivation = derive(scene);
  const ex r = sym("r");
  const ex eq29 = mu0 * w * du_z / GiNaC::abs(kd - m * w * w) *
                  GiNaC::sqrt(GiNaC::pow(w * cn, 2) +
                              GiNaC::pow(1 / r, 2) * GiNaC::pow(r * kn + kd - m * w * w, 2));
  BOOST_TEST(equal(derivation.critical_velocity, eq29));
  BOOST_TEST(derivation.equation == "(29)");
  BOOST_TEST(equal(limit(limits(derive(scene)), "(31)").result, mu0 * w * du_z / r));
}

BOOST_AUTO_TEST_CASE(elastic_scenes_read_as_in_the_paper) {
  const Scene elastic = test::scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m");
  BOOST_TEST(to_text(derive(elastic).critical_velocity) ==
             "mu0*omega*du_z*kn*abs(kd + kt - m*omega^2)/(kt*abs(kd - m*omega^2))");
  const Scene rigid = test::scene_of("normal = \"kn\"\ntangential = \"kt\"");
  BOOST_TEST(to_text(derive(rigid).critical_velocity) == "mu0*omega*du_z*kn/kt");
  BOOST_TEST(derive(rigid).equation == "(31)");
}

BOOST_AUTO_TEST_CASE(isotropic_contact_under_a_rigid_drive_has_no_rheology_left) {
  for (const char* network : {"kelvin(k1, c1)", "zener(k0, k1, c1)", "burgers(k1, c1, k2, c2)",
                              "prony(k0, k, tau, 10)", "k1 - c1 | (k2 | c2 - k3) - c3", "bridge"}) {
    const std::string normal = std::string("normal = \"") + network + "\"\n";
    const bool graph = std::string(network) == "bridge";
    const std::string rest = graph ? test::bridge_network : "";
    const Derivation by_number = derive(test::scene_of(normal + "poisson = 0.3", "", "", rest));
    // 2(1 - 0.3)/(2 - 0.3) = 14/17
    BOOST_TEST(to_text(by_number.critical_velocity) == "17/14*mu0*omega*du_z");
    BOOST_TEST((by_number.parameters == std::vector<Symbol>{{"mu0"}, {"omega"}, {"du_z"}}));
    const Derivation by_symbol = derive(test::scene_of(normal + "poisson = \"nu\"", "", "", rest));
    BOOST_TEST(to_text(by_symbol.critical_velocity) == "mu0*omega*du_z*(2 - nu)/(2*(1 - nu))");
    const Derivation by_ratio =
        derive(test::scene_of(normal + "tangential_ratio = 0.8", "", "", rest));
    BOOST_TEST(to_text(by_ratio.critical_velocity) == "5/4*mu0*omega*du_z");
  }
}

BOOST_AUTO_TEST_CASE(one_shape_with_two_sets_of_symbols_becomes_a_constant_too) {
  const Scene scene = test::scene_of(
      "normal = \"zener(k0, k1, c1)\"\ntangential = \"(k3 - c3) | k2\"", "kd | cd", "m");
  const std::vector<Limit> all = limits(derive(scene));
  BOOST_TEST(all.back().name == "isotropic contact, K_t = k2*K_n/k0, K_d -> infinity");
  BOOST_TEST(to_text(all.back().result) == "mu0*omega*du_z*k0/k2");
}

BOOST_AUTO_TEST_CASE(what_a_scene_lacks_never_appears) {
  const std::string rigid =
      print(test::scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"k2 | c2\""),
            {Format::text, true, true});
  for (const char* absent : {"K_d", "m*", "A*", "x''", "mass", "drive", " body", "esonance"})
    BOOST_TEST(rigid.find(absent) == std::string::npos, absent);
  const std::string massless =
      print(test::scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"k2 | c2\"", "kd"),
            {Format::text, true, true});
  BOOST_TEST(massless.find("K_d") != std::string::npos);
  for (const char* absent : {"m*", "x''", "mass", "esonance"})
    BOOST_TEST(massless.find(absent) == std::string::npos, absent);
}

BOOST_AUTO_TEST_CASE(a_drive_equal_to_the_contact_cancels) {
  const Scene scene = test::scene_of("normal = \"k1 | c1\"\ntangential_ratio = 0.5", "k1 | c1");
  // K_t + K_d = 3/2 K, K_d = K, K_t = K/2.
  BOOST_TEST(to_text(derive(scene).critical_velocity) == "3*mu0*omega*du_z");
}

BOOST_AUTO_TEST_CASE(numbers_are_taken_as_written) {
  BOOST_TEST(exact_decimal(0.3).is_equal(GiNaC::numeric(3, 10)));
  BOOST_TEST(exact_decimal(1e-5).is_equal(GiNaC::numeric(1, 100000)));
  BOOST_TEST(exact_decimal(2.5e6).is_equal(GiNaC::numeric(2500000)));
  BOOST_TEST(exact_binary(0.375).is_equal(GiNaC::numeric(3, 8)));
  BOOST_TEST(!exact_binary(0.3).is_equal(GiNaC::numeric(3, 10)));
}

// What two scenes have in common is derived once; its words are each scene's.
BOOST_AUTO_TEST_CASE(words_are_those_of_the_scene_that_is_printed) {
  const auto first_words = [](const char* normal) {
    const Scene scene = test::scene_of(std::string("normal = \"") + normal + "\"\npoisson = 0.3");
    const NamesOfScene names(scene);
    return derive(scene).lines.front().words.text();
  };
  BOOST_TEST(first_words("spring(y)").find("(y_own: its") != std::string::npos);
  BOOST_TEST(first_words("spring(a)").find("(y: its") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
