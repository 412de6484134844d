// The retardation spectrum of a network adds up to its compliance.
#include <boost/test/unit_test.hpp>

#include "analysis/retardation.hpp"
#include "analysis/rheology.hpp"
#include "derivation/scenes.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"

BOOST_AUTO_TEST_SUITE(test_retardation)

using namespace vcrit;
using namespace vcrit::symbolic;
using GiNaC::ex;

namespace {

Network network_of(const std::string& normal) {
  return test::scene_of("normal = \"" + normal + "\"\npoisson = 0.3").normal;
}

/// lambda_i and j_i put in, at exact values of the elements: a number, of which a pair of times has
/// roots. 40 digits are left of 60.
ex at_values(const RetardationSpectrum& spectrum, ex sum, const Network& network) {
  for (const auto& [time, compliance] : spectrum.lines)
    sum = sum.subs(compliance.left == compliance.right);
  for (const auto& [time, compliance] : spectrum.lines) sum = sum.subs(time.left == time.right);
  GiNaC::exmap values{{laplace(), GiNaC::numeric(3, 7)}};
  int next = 2;
  for (const Symbol& each : symbols_of(network)) values[symbol(each)] = GiNaC::numeric(next++, 3);
  return sum.subs(values).evalf();
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_adds_up_to_the_compliance) {
  GiNaC::Digits = 60;
  for (const char* text :
       {"k0", "c0", "kelvin(k, c)", "maxwell(k, c)", "zener(k0, k1, c1)", "jeffreys(c0, k1, c1)",
        "burgers(k1, c1, k2, c2)", "k0 | (k1 - c1) | (k2 - c2)",
        "(k1 | c1) - (k2 | c2) - (k3 | c3)", "k0 - (c1 | (k2 - c2))", "prony(k0, k, tau, 2)"}) {
    const Network network = network_of(text);
    const auto spectrum = retardation_spectrum(network);
    BOOST_TEST_REQUIRE(spectrum.has_value(), text);
    const Fraction k = stiffness_in_lowest_terms(network);
    const ex wanted = at_values({}, k.denominator / k.numerator, network);
    const ex found = at_values(*spectrum, spectrum->sum(), network);
    BOOST_TEST(bool(GiNaC::abs(found - wanted) < GiNaC::pow(ex(10), -40)), text);
  }
}

// By hand: 1/K of k0 | (k1 - c1) is 1/(k0 + k1) at once, 1/k0 at rest.
BOOST_AUTO_TEST_CASE(zener_by_hand) {
  const auto spectrum = retardation_spectrum(network_of("zener(k0, k1, c1)")).value();
  BOOST_TEST(to_text(spectrum.glassy) == "1/(k0 + k1)");
  BOOST_TEST(spectrum.fluidity.is_zero());
  BOOST_TEST(to_text(spectrum.lines.at(0).time.right) == "c1*(k0 + k1)/(k0*k1)");
  BOOST_TEST(to_text(spectrum.lines.at(0).compliance.right) == "k1/(k0*(k0 + k1))");
}

BOOST_AUTO_TEST_CASE(masses_lossy_springs_and_many_times_have_none) {
  BOOST_TEST(!retardation_spectrum(network_of("lossy(k, eta)")));
  BOOST_TEST(!retardation_spectrum(network_of("prony(k0, k, tau, 3)")));
}

BOOST_AUTO_TEST_SUITE_END()
