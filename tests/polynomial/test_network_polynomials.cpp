// Networks multiplied out: as many terms as were announced, and the value of K(s).
#include <boost/test/unit_test.hpp>

#include <set>

#include "derivation/scenes.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "network/reduction.hpp"
#include "polynomial/network_polynomials.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_network_polynomials)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

Network network(const std::string& normal, const std::string& rest = "") {
  return test::scene_of("normal = \"" + normal + "\"\ntangential_ratio = 1.0", "", "", rest).normal;
}

/// A ladder of springs in line and dampers to ground, from its far end.
std::string ladder(int elements) {
  std::string text = elements % 2 == 0 ? "c" : "k";
  text += std::to_string(elements);
  for (int i = elements - 1; i > 0; --i)
    text = i % 2 == 1 ? "k" + std::to_string(i) + " - (" + text + ")"
                      : "c" + std::to_string(i) + " | (" + text + ")";
  return text;
}

Ring ring_of(const Network& network) {
  std::set<std::string> names{own_name("s")};
  for (const Symbol& symbol : symbols_of(network)) names.insert(to_text(symbol));
  return Ring({names.begin(), names.end()});
}

/// Numerator or denominator at exact numbers.
GiNaC::numeric value(const Polynomial& polynomial,
                     const std::map<std::string, GiNaC::numeric>& at) {
  GiNaC::numeric sum = 0;
  for (std::size_t i = 0; i < polynomial.terms(); ++i) {
    GiNaC::numeric term(polynomial.coefficient(i).c_str());
    const auto exponents = polynomial.exponents(i);
    for (std::size_t v = 0; v < exponents.size(); ++v)
      term *= GiNaC::pow(at.at(polynomial.ring().names()[v]),
                         GiNaC::numeric(static_cast<long>(exponents[v])));
    sum += term;
  }
  return sum;
}

/// K at exact numbers, by the reduction.
struct Exact {
  using Value = GiNaC::numeric;
  const std::map<std::string, GiNaC::numeric>& at;
  Value element(const Element& e) const {
    const Value k = at.at(to_text(e.coefficient)), s = at.at(own_name("s"));
    if (e.kind == ElementKind::spring) return k;
    if (e.kind == ElementKind::damper) return k * s;
    const Value turn = at.at(to_text(e.second)) * s;
    return k * turn / (turn + 1);
  }
  Value parallel(const Value& a, const Value& b) const { return a + b; }
  Value series(const Value& a, const Value& b) const { return a * b / (a + b); }
  Value mesh(const Value& a, const Value& b, const Value& total) const { return a * b / total; }
};

void check(const Network& network, bool distinct) {
  const Ring ring = ring_of(network);
  const PolynomialQuotient k = stiffness(network, ring);
  const TermNumbers announced = term_numbers(network);
  if (distinct) {
    BOOST_TEST(static_cast<double>(k.over.terms()) == announced.over);
    BOOST_TEST(static_cast<double>(k.under.terms()) == announced.under);
  } else {
    BOOST_TEST(static_cast<double>(k.over.terms()) <= announced.over);
    BOOST_TEST(static_cast<double>(k.under.terms()) <= announced.under);
  }
  std::map<std::string, GiNaC::numeric> at;
  int i = 3;
  for (const std::string& name : ring.names()) at[name] = GiNaC::numeric(i += 2, 7);
  Exact exact{at};
  BOOST_TEST((value(k.over, at) / value(k.under, at)).is_equal(evaluate(reduce(network), exact)));
  // Nothing divides both.
  BOOST_TEST(cancelled(k).over.terms() == k.over.terms());
  BOOST_TEST(std::min(k.over.lowest_degree(own_name("s")), k.under.lowest_degree(own_name("s"))) ==
             0U);
}

}  // namespace

BOOST_AUTO_TEST_CASE(zener_by_hand) {
  const Network zener = network("k0 | (k1 - c1)");
  const Ring ring({own_name("s"), "c1", "k0", "k1"});
  const auto v = [&](const std::string& name) { return Polynomial::variable(ring, name); };
  const PolynomialQuotient k = stiffness(zener, ring);
  BOOST_TEST((k.over == v("k0") * v("k1") + v(own_name("s")) * v("c1") * (v("k0") + v("k1"))));
  BOOST_TEST((k.under == v("k1") + v(own_name("s")) * v("c1")));
}

BOOST_AUTO_TEST_CASE(terms_are_announced) {
  // A ladder's terms are Fibonacci's numbers; of n Maxwell branches beside a spring, numerator and
  // denominator have 2^n + n 2^(n - 1) and 2^n terms; a wheel of four spokes between neighbours on
  // its rim, less one edge, counted by hand below.
  const TermNumbers ladder20 = term_numbers(network(ladder(20)));
  BOOST_TEST(ladder20.over == 6765);
  BOOST_TEST(ladder20.under == 10946);
  const TermNumbers prony20 = term_numbers(network("prony(k0, k, tau, 20)"));
  BOOST_TEST(prony20.over == 11534336);
  BOOST_TEST(prony20.under == 1048576);
  // The bridge: 8 spanning trees of the complete graph on four nodes less one edge, and as many
  // pairs of trees.
  const TermNumbers bridge = term_numbers(network("bridge", test::bridge_network));
  BOOST_TEST(bridge.over == 8);
  BOOST_TEST(bridge.under == 8);
}

BOOST_AUTO_TEST_CASE(networks_have_their_value) {
  check(network("kelvin(k1, c1)"), true);
  check(network("burgers(k1, c1, k2, c2)"), true);
  check(network("prony(k0, k, tau, 8)"), true);
  check(network("c1 - c2 - k3"), true);
  check(network(ladder(16)), true);
  check(network("bridge", test::bridge_network), true);
  check(network("bridge | k9 - c9", test::bridge_network), true);
  check(network("(k1 - c1) | (k1 - c2) | k1"), false);
}

BOOST_AUTO_TEST_CASE(random_networks_have_their_value) {
  test::RandomScenes random(20261121, 1);
  int graphs = 0;
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    const Network drawn = random.network(i % 11 + 1, "n", scene);
    graphs += std::holds_alternative<Graph>(drawn.form) ? 1 : 0;
    check(drawn, true);
  }
  BOOST_TEST(graphs > 20);
}

BOOST_AUTO_TEST_SUITE_END()
