#include "analysis/rational_form.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "formula/form.hpp"
#include "formula/names.hpp"
#include "formula/rational.hpp"
#include "formula/symbols.hpp"
#include "polynomial/network_polynomials.hpp"
#include "polynomial/quotient_algebra.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

struct CountAlgebra {
  using Value = TermNumbers;
  const std::map<std::string, TermNumbers>& networks;

  Value number(const GiNaC::numeric&) const { return {1, 1}; }
  Value name(const std::string& name) const {
    const auto found = networks.find(name);
    return found == networks.end() ? TermNumbers{1, 1} : found->second;
  }
  Value add(const Value& a, const Value& b) const {
    return {a.over * b.under + b.over * a.under, a.under * b.under};
  }
  Value multiply(const Value& a, const Value& b) const {
    return {a.over * b.over, a.under * b.under};
  }
  Value invert(const Value& a) const { return {a.under, a.over}; }
};

/// Networks as well.
struct StiffnessAlgebra : QuotientAlgebra {
  Value of(const Symbol& symbol) const { return name(to_text(symbol)); }
  Value constant(const TypedNumber& given) const { return number(exact_decimal(given.decimal)); }
  Value plus(const Value& a, const Value& b) const { return add(a, b); }
  Value times(const Value& a, const Value& b) const { return multiply(a, b); }
  Value over(const Value& a, const Value& b) const { return multiply(a, turned_over(b)); }
  Value times_s(const Value& k) const { return multiply(k, name(own_name("s"))); }
  Value relaxing(const Value& k, const Value& tau) const {
    const Value turn = times_s(tau);
    return multiply(multiply(k, turn), turned_over(add(turn, number(1))));
  }
  Value parallel(const Value& a, const Value& b) const { return add(a, b); }
  Value series(const Value& a, const Value& b) const { return mesh(a, b, add(a, b)); }
  Value mesh(const Value& a, const Value& b, const Value& total) const {
    return multiply(multiply(a, b), turned_over(total));
  }
};

/// The symbols of all polynomials, in natural order behind s and omega.
std::vector<std::string> variables(const SymbolicModel& model, const ex& amplitude) {
  std::set<std::string> names;
  for (auto it = amplitude.preorder_begin(); it != amplitude.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it)) names.insert(GiNaC::ex_to<GiNaC::symbol>(*it).get_name());
  for (const NamedNetwork& part : model.networks()) {
    if (names.erase(own_name(part.name)) == 0) continue;
    for (const Symbol& each : symbols_of(part.network.network())) names.insert(to_text(each));
  }
  names.erase(own_name("s"));
  std::vector<std::string> sorted(names.begin(), names.end());
  std::sort(sorted.begin(), sorted.end(), natural_less);
  sorted.insert(sorted.begin(), {own_name("s"), "omega"});
  return sorted;
}

/// |f|^2 at s = i omega.
Polynomial squared_modulus(const Polynomial& f) {
  const Ring& ring = f.ring();
  const std::size_t s = ring.index(own_name("s")), omega = ring.index("omega");
  Polynomial even(ring, 0), odd(ring, 0);
  for (std::size_t i = 0; i < f.terms(); ++i) {
    std::vector<unsigned long> exponents = f.exponents(i);
    const unsigned long power = exponents[s];
    exponents[omega] += std::exchange(exponents[s], 0);
    std::string coefficient = f.coefficient(i);
    if (power % 4 >= 2)
      coefficient = coefficient.starts_with('-') ? coefficient.substr(1) : "-" + coefficient;
    (power % 2 == 0 ? even : odd).add_term(coefficient, exponents);
  }
  return even * even + odd * odd;
}

/// From B/(mu0 du_z).
// Of terms, multiplied in a second.
constexpr double most_products = 5e7;

// What of b has no common factor in s has none in omega^2 either, but powers of omega: numerator
// and denominator of a passive network have no root in s with a positive real part, so that a root
// of one at s can be one of the other at -s on the imaginary axis alone, and would then be one of
// both at s.
RationalForm squared_form(const std::shared_ptr<const Ring>& ring, const PolynomialQuotient& b) {
  const double over = static_cast<double>(b.over.terms()),
               under = static_cast<double>(b.under.terms());
  if (over * over + under * under > most_products)
    throw ModelError(fmt::format(
        "squared, the polynomials of v* of {:.6g} and {:.6g} terms make some {:.2g} products", over,
        under, over * over + under * under));
  PolynomialQuotient square{Polynomial::power(*ring, "omega", 2) * squared_modulus(b.over),
                            squared_modulus(b.under)};
  const unsigned long common =
      std::min(square.over.lowest_degree("omega"), square.under.lowest_degree("omega"));
  return {
      ring,
      {square.over.without_power("omega", common), square.under.without_power("omega", common)}};
}

}  // namespace

double terms_before_squaring(const SymbolicModel& model) {
  std::map<std::string, TermNumbers> networks;
  for (const NamedNetwork& part : model.networks())
    networks[own_name(part.name)] = term_numbers(part.network.network());
  const TermNumbers count = evaluate_rational(model.per_friction(), CountAlgebra{networks});
  return std::max(count.over, count.under);
}

Amplitude multiplied_out(const SymbolicModel& model, double budget, const Change& change) {
  const double terms = terms_before_squaring(model);
  if (terms > budget)
    throw ModelError(fmt::format(
        "multiplied out, v* has polynomials of {:.6g} terms, more than the budget of {:.6g}", terms,
        budget));
  const ex amplitude = change.ratio
                           ? (model.amplitude(change) / symbol({"mu0"}) / symbol({"du_z"})).normal()
                           : model.per_friction();
  ensure(!amplitude.has(quantity("R_d")), "who wants polynomials has asked the rulebook");
  auto ring = std::make_shared<const Ring>(variables(model, amplitude));
  QuotientAlgebra algebra{*ring, {}};
  for (const NamedNetwork& part : model.networks())
    if (amplitude.has(quantity(part.name)))
      algebra.known.emplace(own_name(part.name), stiffness(part.network.network(), *ring));
  return {ring, evaluate_rational(amplitude, algebra)};
}

RationalForm rational_form(const SymbolicModel& model, double budget, const Change& change) {
  const Amplitude amplitude = multiplied_out(model, budget, change);
  return squared_form(amplitude.ring, amplitude.per_friction);
}

RationalForm rational_form(const SymbolicModel& model,
                           const std::map<std::string, GiNaC::numeric>& values) {
  const ex amplitude = model.per_friction();
  const auto ring = std::make_shared<const Ring>(std::vector<std::string>{own_name("s"), "omega"});
  StiffnessAlgebra algebra{{*ring, {}}};
  for (const auto& [name, value] : values) algebra.known.emplace(name, algebra.number(value));
  for (const NamedNetwork& part : model.networks())
    if (amplitude.has(quantity(part.name)))
      algebra.known.emplace(own_name(part.name), evaluate(part.network.reduction(), algebra));
  return squared_form(ring, evaluate_rational(amplitude, algebra));
}

std::string canonical_text(const RationalForm& form) {
  const std::vector<std::string>& names = form.ring->names();
  std::string text;
  for (const Polynomial* polynomial : {&form.square.over, &form.square.under}) {
    text += text.empty() ? "" : "/";
    for (std::size_t i = 0; i < polynomial->terms(); ++i) {
      text += fmt::format(" {}", polynomial->coefficient(i));
      const auto exponents = polynomial->exponents(i);
      for (std::size_t v = 0; v < names.size(); ++v)
        if (exponents[v] > 0) text += fmt::format("*{}^{}", names[v], exponents[v]);
    }
  }
  return text;
}

std::size_t products_of_extrema(const RationalForm& form) {
  return form.square.over.terms() * form.square.under.terms();
}

Polynomial stationary(const RationalForm& form) {
  const auto& [over, under] = form.square;
  const Polynomial slope = over.derivative("omega") * under - over * under.derivative("omega");
  if (slope.is_zero()) return slope;
  // Factors that D has twice cancel against D^2.
  const Polynomial left = cancelled({slope, under * under}).over;
  return left.without_power("omega", left.lowest_degree("omega")).primitive("omega");
}

}  // namespace vcrit::symbolic
