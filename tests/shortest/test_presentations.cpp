// Every way in which the stiffness of a network is written is that stiffness.
#include <boost/test/unit_test.hpp>

#include <complex>

#include "derivation/scenes.hpp"
#include "network/reduction.hpp"
#include "shortest/presentations.hpp"
#include "shortest/value_of.hpp"

BOOST_AUTO_TEST_SUITE(test_presentations)

using namespace vcrit;
using namespace vcrit::symbolic::shortest;
using vcrit::test::value_of;

namespace {

constexpr double omega = 1.3;

struct Numbers {
  using Value = std::complex<double>;
  const std::map<Symbol, double>& values;
  Value of(const Symbol& symbol) const { return values.at(symbol); }
  static Value constant(const TypedNumber& number) { return number.value; }
  static Value plus(const Value& a, const Value& b) { return a + b; }
  static Value times(const Value& a, const Value& b) { return a * b; }
  static Value over(const Value& a, const Value& b) { return a / b; }
  Value times_s(const Value& k) const { return k * Value(0, omega); }
  Value relaxing(const Value& k, const Value& tau) const {
    const Value turn = times_s(tau);
    return k * turn / (1.0 + turn);
  }
  Value lossy(const Value& k, const Value& eta) const { return k * (1.0 + Value(0, 1) * eta); }
  Value parallel(const Value& a, const Value& b) const { return a + b; }
  Value series(const Value& a, const Value& b) const { return a * b / (a + b); }
  Value mesh(const Value& a, const Value& b, const Value& total) const { return a * b / total; }
};

void check(const Network& network) {
  Expressions all;
  const Ex w = all.symbol("omega");
  std::map<Symbol, Ex> symbols;
  std::map<Symbol, double> values;
  std::map<ExNode, double> known{{w.node, omega}};
  double next = 0.4;
  for (const Symbol& symbol : symbols_of(network)) {
    symbols[symbol] = all.symbol(to_text(symbol));
    values[symbol] = known[symbols[symbol].node] = next = next * 1.7 > 3 ? next / 5 : next * 1.7;
  }
  Presentations presentations(all, w, [&](const Symbol& s) { return symbols.at(s); }, {});
  const auto number = [&](const Ex& ex) {
    return value_of(ex.factor) * value_of(all, ex.node, known);
  };
  const auto complex = [&](const ComplexEx& z) {
    return std::complex<double>(number(z.re), number(z.im));
  };
  Numbers numbers{values};
  const std::complex<double> wanted = evaluate(reduce(network), numbers);
  for (const ComplexQuotient& each : presentations.of(network)) {
    const std::complex<double> found = complex(each.over) / complex(each.under);
    BOOST_TEST(std::abs(found - wanted) < 1e-12 * std::abs(wanted));
  }
}

Network network_of(const std::string& text, const std::string& rest = "") {
  return test::scene_of("normal = \"k9\"\npoisson = 0.3", text, "", rest).drive.value();
}

}  // namespace

BOOST_AUTO_TEST_CASE(of_springs_and_dampers) {
  for (const char* text :
       {"k0", "k0 | c0", "k0 - c0", "zener(k0, k1, c1)", "k0 - (k1 | c1)",
        "burgers(k1, c1, k2, c2)", "k0 | (k1 - c1) | (k2 - c2)", "k0 | (k1 - (c1 | (k2 - c2)))",
        "k0 | (k1 - c1 - c2)", "prony(k0, k, tau, 3)", "k0 - k1 - (k2 | c2 | c3) - c4",
        "lossy(k0, eta)", "lossy(k0, eta) - (k1 | c1)",
        "k0 - (mass(m1) | k1 - (mass(m2) | k2 | c2))"})
    check(network_of(text));
}

BOOST_AUTO_TEST_CASE(of_graphs) {
  check(network_of("bridge", test::bridge_network));
  check(network_of("k0 | bridge - c9", test::bridge_network));
}

BOOST_AUTO_TEST_CASE(networks_of_one_form_are_alike) {
  const Network whole = network_of("(k1 - c1) | (k2 - c2) | (k3 - c3 - k4) | (c4 - k5)");
  const auto& parts = std::get<Parallel>(whole.form).parts;
  BOOST_TEST(alike(parts) == (std::vector<int>{0, 0, 1, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
