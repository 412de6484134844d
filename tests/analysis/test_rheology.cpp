// Storage, loss and spectrum against an evaluation of the network itself in exact complex numbers,
// against the numeric relaxation form, and as identities.
#include "analysis/rheology.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "analysis/exact_scene.hpp"
#include "derivation/scenes.hpp"
#include "formula/text.hpp"
#include "network/catalogue.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "stiffness/relaxation.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

using GiNaC::ex;
using GiNaC::numeric;

Network network_of(const std::string& expression) {
  return test::scene_of("normal = \"" + expression + "\"\npoisson = 0.3").normal;
}

/// The catalogue without masses, and combinations that it does not have.
std::vector<Network> networks() {
  std::vector<Network> all;
  for (const Rheology& rheology : catalogue()) {
    std::vector<std::string> names;
    for (const auto& [name, kind] : rheology.arguments) names.push_back(name);
    // Three rungs of a ladder have three times, which no closed form has.
    const Network network = rheology.build(names, rheology.is_nested ? 2 : 3);
    if (!has_masses(network)) all.push_back(network);
  }
  for (const char* expression : {"(k1 | c1) - (k2 | c2)", "c0 | zener(k0, k1, c1) - k2",
                                 "k0 | burgers(k1, c1, k2, c2) | (k3 - c3)"})
    all.push_back(network_of(expression));
  return all;
}

using Exact = std::map<Symbol, numeric>;

/// Random fractions for the elements.
Exact values_for(const Network& network, std::mt19937& random) {
  Exact values;
  for (const Symbol& symbol : symbols_of(network))
    values[symbol] =
        numeric(1 + static_cast<long>(random() % 97), 1 + static_cast<long>(random() % 31));
  return values;
}

numeric number_in(const AmountTree& e, const Exact& values) {
  if (e.kind == AmountTree::Kind::symbol) return values.at(e.symbol);
  BOOST_REQUIRE(e.kind == AmountTree::Kind::product);  // the catalogue has no others
  return number_in(*e.first, values) * number_in(*e.second, values);
}

numeric number_in(const Amount& amount, const Exact& values) {
  return amount.is_symbol() ? values.at(amount.symbol()) : number_in(*amount.expression(), values);
}

/// K at a complex s, from the definition of series and parallel.
numeric stiffness_at(const Network& network, const Exact& values, const numeric& s) {
  if (const auto* e = std::get_if<Element>(&network.form)) {
    const numeric k = number_in(e->coefficient, values);
    if (e->kind == ElementKind::spring) return k;
    if (e->kind == ElementKind::damper) return k * s;
    if (e->kind == ElementKind::lossy) return k * (1 + GiNaC::I * number_in(e->second, values));
    const numeric turn = number_in(e->second, values) * s;
    return k * turn / (1 + turn);
  }
  numeric sum = 0;
  if (const auto* parallel = std::get_if<Parallel>(&network.form)) {
    for (const Network& part : parallel->parts) sum += stiffness_at(part, values, s);
    return sum;
  }
  for (const Network& part : std::get<Series>(network.form).parts)
    sum += stiffness_at(part, values, s).inverse();
  return sum.inverse();
}

ex put_in(const ex& formula, const Exact& values, const numeric& w) {
  GiNaC::exmap map{{omega(), w}, {laplace(), GiNaC::I * w}};
  for (const auto& [name, value] : values) map[symbol(name)] = value;
  return formula.subs(map);
}

/// Random doubles over six decades.
Values doubles_for(const Network& network, std::mt19937& random) {
  Values values;
  for (const Symbol& symbol : symbols_of(network))
    values[symbol] = std::pow(2.0, static_cast<double>(random() % 2001) / 100 - 10);
  return values;
}

/// The spectrum with values put in, by increasing time.
Relaxation in_numbers(const RelaxationSpectrum& spectrum, const Values& values) {
  Exact exact;
  for (const auto& [symbol, value] : values) exact[symbol] = exact_binary(value);
  const auto number = [&](const ex& formula) {
    const ex value = put_in(spectrum.in_elements(formula), exact, 1).evalf();
    return GiNaC::ex_to<numeric>(value).to_double();
  };
  Relaxation result{number(spectrum.equilibrium), number(spectrum.damper), {}};
  for (const auto& [time, strength] : spectrum.lines)
    result.branches.push_back({number(strength.left), number(time.left)});
  std::sort(result.branches.begin(), result.branches.end(),
            [](const auto& a, const auto& b) { return a.time < b.time; });
  return result;
}

bool times_are_apart(const Relaxation& form) {
  for (std::size_t j = 1; j < form.branches.size(); ++j)
    if (form.branches[j].time <= 2 * form.branches[j - 1].time) return false;
  return true;
}

std::string line_text(const Line& line) { return to_text(line.left) + " = " + to_text(line.right); }

}  // namespace

// Fractions are exact: the difference is 0, not small.
BOOST_AUTO_TEST_CASE(storage_and_loss_are_the_parts_of_the_stiffness) {
  constexpr unsigned seed = 4711;
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  for (const Network& network : networks()) {
    const Response found = response(network);
    for (int i = 0; i < 5; ++i) {
      const Exact values = values_for(network, random);
      const numeric w(1 + static_cast<long>(random() % 50), 1 + static_cast<long>(random() % 9));
      const numeric expected = stiffness_at(network, values, GiNaC::ex_to<numeric>(GiNaC::I) * w);
      BOOST_TEST_CONTEXT(to_text(found.stiffness)) {
        BOOST_TEST((put_in(found.stiffness, values, w) - expected).expand().is_zero());
        BOOST_TEST((put_in(found.storage, values, w) - expected.real()).is_zero());
        BOOST_TEST((put_in(found.loss, values, w) - expected.imag()).is_zero());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_spectrum_adds_up_to_the_stiffness) {
  for (const Network& network : networks()) {
    const auto found = spectrum(network);
    BOOST_REQUIRE(found.has_value() == is_rational(network));
    if (!found) continue;
    const ex difference = response(network).stiffness - found->in_elements(found->sum());
    // Squares of roots become plain only after the product is expanded.
    BOOST_TEST(difference.normal().numer().expand().normal().is_zero(),
               to_text(response(network).stiffness));
  }
}

// The numeric form errs by about 10 roundings there and back at each of up to 5 crossings, 100 u.
// A strength is read off at its time and moves with 1/(1 - tau_2/tau_1) of it, here below 2 as
// the times are kept apart by more than 2: 200 u for the way in, as much again for the way out.
BOOST_AUTO_TEST_CASE(the_spectrum_is_that_of_the_numeric_relaxation_form) {
  constexpr double tolerance = 400 * 0x1p-53;
  constexpr unsigned seed = 99;
  BOOST_TEST_MESSAGE("seed " << seed);
  const auto close = [](double a, double b) { return std::abs(a - b) <= tolerance * b; };
  GiNaC::Digits = 60;
  std::mt19937 random(seed);
  int compared = 0;
  for (const Network& network : networks())
    for (int i = 0; i < 20 && is_rational(network); ++i) {
      const Values values = doubles_for(network, random);
      const Relaxation expected = relaxation_form(network, values);
      const Relaxation found = in_numbers(*spectrum(network), values);
      BOOST_TEST(close(found.equilibrium, expected.equilibrium));
      BOOST_TEST(close(found.damper, expected.damper));
      if (!times_are_apart(found)) continue;
      ++compared;
      BOOST_REQUIRE(found.branches.size() == expected.branches.size());
      for (std::size_t j = 0; j < found.branches.size(); ++j) {
        BOOST_TEST(close(found.branches[j].time, expected.branches[j].time));
        BOOST_TEST(close(found.branches[j].stiffness, expected.branches[j].stiffness));
      }
    }
  BOOST_TEST(compared > 100);
}

BOOST_AUTO_TEST_CASE(rest_and_the_first_moment) {
  const auto texts = [](const std::string& expression) {
    const StiffnessExtremes e = extremes(network_of(expression));
    return std::vector<std::string>{to_text(e.equilibrium), to_text(e.viscosity), to_text(e.glassy),
                                    to_text(e.damper)};
  };
  using Texts = std::vector<std::string>;
  BOOST_TEST((texts("k") == Texts{"k", "0", "k", "0"}));
  BOOST_TEST((texts("k | c") == Texts{"k", "0", "0", "c"}));
  BOOST_TEST((texts("k0 | (k1 - c1)") == Texts{"k0", "0", "k0 + k1", "0"}));
  BOOST_TEST((texts("c0 | (k1 - c1)") == Texts{"0", "c0 + c1", "0", "c0"}));
  BOOST_TEST((texts("k1 - c1 - (k2 | c2)") == Texts{"0", "c1", "k1", "0"}));
  // K = k (1 + i eta) at every frequency: no damper, whose K(s)/s would depend on omega.
  BOOST_TEST((texts("lossy(k, eta)") == Texts{"k", "0", "0", "0"}));
}

// Compliance of a Burgers liquid: 1/k1 + 1/(c1 s) + 1/(k2 + c2 s); the denominator of K is
// k1 k2 + (c1 k1 + c1 k2 + c2 k1) s + c1 c2 s^2.
BOOST_AUTO_TEST_CASE(formulas_read_well) {
  const Response zener = response(network_of("k0 | (k1 - c1)"));
  BOOST_TEST(to_text(zener.stiffness) == "(k0*k1 + c1*k0*s + c1*k1*s)/(k1 + c1*s)");
  BOOST_TEST(to_text(zener.loss) == "omega*c1*k1^2/(k1^2 + c1^2*omega^2)");
  const RelaxationSpectrum burgers = *spectrum(network_of("k1 - c1 - (k2 | c2)"));
  BOOST_TEST(line_text(burgers.lines.at(0).time) ==
             "tau_1 = (c1*k1 + c1*k2 + c2*k1 + sqrt(-4*c1*c2*k1*k2 + (c1*k1 + c1*k2 + c2*k1)^2))"
             "/(2*k1*k2)");
  BOOST_TEST(line_text(burgers.lines.at(0).strength) ==
             "h_1 = -c1*(c2 - k2*tau_1)/(k2*tau_1*(tau_1 - tau_2))");
  BOOST_TEST(line_text(burgers.lines.at(1).strength) ==
             "h_2 = c1*(c2 - k2*tau_2)/(k2*tau_2*(tau_1 - tau_2))");
  BOOST_TEST(to_text(burgers.sum()) == "h_1*tau_1*s/(1 + tau_1*s) + h_2*tau_2*s/(1 + tau_2*s)");
}

BOOST_AUTO_TEST_CASE(branches_stay_as_they_are_given) {
  const RelaxationSpectrum found = *spectrum(network_of("prony(k0, k, tau, 3)"));
  BOOST_REQUIRE(found.lines.size() == 3U);
  BOOST_TEST(line_text(found.lines[2].time) == "tau[3] = tau[3]");
  BOOST_TEST(line_text(found.lines[2].strength) == "k[3] = k[3]");
}

BOOST_AUTO_TEST_CASE(a_mass_has_a_stiffness_and_no_spectrum) {
  const Network network = mass({"m"});
  BOOST_TEST(to_text(response(network).stiffness) == "m*s^2");
  BOOST_TEST(to_text(response(network).storage) == "-m*omega^2");
  BOOST_TEST(response(network).loss.is_zero());
  BOOST_TEST(!spectrum(network).has_value());
}

// Three retardation times one behind the other: a cubic.
BOOST_AUTO_TEST_CASE(more_than_two_times_of_one_part_have_no_closed_form) {
  BOOST_TEST(!spectrum(network_of("(k1 | c1) - (k2 | c2) - (k3 | c3) - (k4 | c4)")).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
