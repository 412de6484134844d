#include "analysis/sensitivities.hpp"

#include <algorithm>
#include <map>

#include "analysis/logarithmic.hpp"
#include "base/interruption.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "formula/real_part.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// What is longer anyway is not worth the time to make it one fraction.
constexpr std::size_t longest_joined_text = 120;

bool is_poisson(const Problem& problem, const Symbol& parameter) {
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  return isotropic != nullptr && isotropic->by == Isotropic::By::poisson &&
         isotropic->quantity.symbol == parameter;
}

ex variable(const Problem& problem, const Symbol& parameter) {
  return is_poisson(problem, parameter) ? poisson_ratio(parameter) : symbol(parameter);
}

/// A product of powers of polynomials. GiNaC's has factors that depend on its order of symbols, so
/// those of one exponent are multiplied out.
ex with_powers(const ex& polynomial) {
  const ex found = GiNaC::sqrfree(polynomial);
  std::map<int, ex> bases;
  const auto add = [&](const ex& factor) {
    const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
    const int exponent = is_power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    ex& base = bases.try_emplace(exponent, 1).first->second;
    base = (base * (is_power ? factor.op(0) : factor)).expand();
  };
  if (GiNaC::is_a<GiNaC::mul>(found))
    for (const ex& factor : found) add(factor);
  else
    add(found);
  ex whole = 1;
  for (const auto& [exponent, base] : bases)
    whole *= GiNaC::pow(factored_polynomial(base), exponent);
  return whole;
}

/// The shorter of the expression and the same as one fraction.
ex shorter_of(const ex& expression) {
  const std::size_t length = to_text(expression).size();
  if (length > longest_joined_text) return expression;
  const ex fraction = expression.normal().numer_denom();
  const ex whole = factored_polynomial(fraction.op(0)) / with_powers(fraction.op(1));
  return to_text(whole).size() < length ? whole : expression;
}

/// The chain rule along the definitions K_1, ..., K_n of a nested formula. With dK_j = p dK_j/dp,
/// S_p = Re(p dB/dp/B), and one more for the omega in v* = omega |B|.
class Chain {
 public:
  explicit Chain(const Model& model) : stiffnesses_(model.nested_formula().definitions) {
    amplitude_ = model.factors({});
    for (const Line& line : stiffnesses_) symbols_.push_back(free_symbols(line.right));
  }

  /// Relative sensitivity and its definitions.
  Sensitivity along(const Symbol& parameter, const ex& variable) {
    const bool is_frequency = variable.is_equal(omega());
    const Changes changes(is_frequency ? laplace() : variable, *this);
    ex sum = 0;
    for (const auto& [factor, exponent] : amplitude_.parts())
      sum += exponent * factored_polynomial(changes.of(factor)) / factor;
    const ex relative = real_part_of(sum.subs(laplace() == GiNaC::I * omega()));
    GiNaC::lst formulas{sum};
    for (const Line& line : changes.lines) formulas.append(line.right);
    return {parameter,
            relative + (is_frequency ? 1 : 0),
            {},
            used_in(formulas, stiffnesses_),
            changes.lines};
  }

 private:
  /// p d/dp of the definitions that depend on p.
  struct Changes {
    ex p;
    std::vector<Line> lines;
    Chain& chain;
    std::map<ex, ex, GiNaC::ex_is_less> known;  ///< K_j, dK_j

    Changes(ex p_, Chain& chain_) : p(std::move(p_)), chain(chain_) {
      for (std::size_t i = 0; i < chain.stiffnesses_.size(); ++i) {
        if (!touches(chain.symbols_[i])) continue;
        const Line& line = chain.stiffnesses_[i];
        const ex change = of_definition(line);
        if (change.is_zero()) continue;
        const std::string name = base_name(GiNaC::ex_to<GiNaC::symbol>(line.left).get_name());
        const ex named = quantity("d" + name);
        known.emplace(line.left, named);
        lines.push_back({"", named, chain.shorter(change)});
      }
    }

    bool touches(const Symbols& symbols) const {
      return symbols.contains(p) || std::any_of(symbols.begin(), symbols.end(),
                                                [&](const ex& k) { return known.contains(k); });
    }

    ex of(const ex& expression) const {
      hear_interruption();
      ex change = 0;
      for (const ex& each : free_symbols(expression)) {
        const auto& symbol = GiNaC::ex_to<GiNaC::symbol>(each);
        if (each.is_equal(p)) change += p * chain.derivative(expression, symbol);
        if (const auto found = known.find(each); found != known.end())
          change += chain.derivative(expression, symbol) * found->second;
      }
      return change;
    }

    // K = 1/u: dK = -K^2 du.
    ex of_definition(const Line& line) const {
      const ex& k = line.right;
      const bool inverse = GiNaC::is_a<GiNaC::power>(k) && k.op(1).is_equal(-1);
      if (inverse) return -GiNaC::pow(line.left, 2) * by_terms(k.op(0));
      return by_terms(k);
    }
    ex by_terms(const ex& sum) const {
      if (!GiNaC::is_a<GiNaC::add>(sum)) return chain.shorter(of(sum));
      ex change = 0;
      for (const ex& term : sum) change += chain.shorter(of(term));
      return change;
    }
  };

  // Links of a long chain are asked for by many parameters.
  ex shorter(const ex& expression) {
    const auto [known, is_new] = shorter_.try_emplace(expression);
    if (is_new) known->second = shorter_of(expression);
    return known->second;
  }
  ex derivative(const ex& expression, const GiNaC::symbol& symbol) {
    const auto [known, is_new] = derivatives_[expression].try_emplace(symbol);
    if (is_new) known->second = expression.diff(symbol);
    return known->second;
  }

  std::vector<Line> stiffnesses_;
  std::vector<Symbols> symbols_;  ///< in each of them
  std::map<ex, ex, GiNaC::ex_is_less> shorter_;
  std::map<ex, std::map<ex, ex, GiNaC::ex_is_less>, GiNaC::ex_is_less> derivatives_;
  Factors amplitude_;
};

/// The chain rule against the order of the definitions: with G_j = (dB/dK_j)/B, all of which follow
/// from one pass, p dB/dp/B = p sum_j G_j dK_j/dp.
class Backwards {
 public:
  explicit Backwards(const Model& model) {
    const Factors amplitude = model.factors({});
    for (const auto& [factor, exponent] : amplitude.parts()) pass_on(exponent / factor, factor);
    const std::vector<Line> definitions = model.nested_formula().definitions;
    for (auto line = definitions.rbegin(); line != definitions.rend(); ++line) {
      hear_interruption();
      const auto found = by_.find(line->left);
      if (found == by_.end()) continue;
      const std::string name = base_name(GiNaC::ex_to<GiNaC::symbol>(line->left).get_name());
      const ex g = quantity("G" + name.substr(1));
      shared.push_back({"", g, found->second});
      pass_on_definition(g, *line);
    }
  }

  Sensitivity along(const Symbol& parameter, const ex& variable) const {
    const bool is_frequency = variable.is_equal(omega());
    const ex p = is_frequency ? laplace() : variable;
    const auto found = by_.find(p);
    const ex sum = found == by_.end() ? ex(0) : p * found->second;
    const ex relative = real_part_of(sum.subs(laplace() == GiNaC::I * omega()));
    return {parameter, relative + (is_frequency ? 1 : 0), {}, {}, {}};
  }

  std::vector<Line> shared;

 private:
  // K = 1/u: dK = -K^2 du.
  void pass_on_definition(const ex& g, const Line& line) {
    const ex& k = line.right;
    if (GiNaC::is_a<GiNaC::power>(k) && k.op(1).is_equal(-1))
      pass_on_terms(-g * GiNaC::pow(line.left, 2), k.op(0));
    else
      pass_on_terms(g, k);
  }
  void pass_on_terms(const ex& weight, const ex& sum) {
    if (!GiNaC::is_a<GiNaC::add>(sum)) return pass_on(weight, sum);
    for (const ex& term : sum) pass_on(weight, term);
  }
  void pass_on(const ex& weight, const ex& term) {
    for (const ex& each : free_symbols(term))
      by_[each] += weight * shorter_of(term.diff(GiNaC::ex_to<GiNaC::symbol>(each)));
  }

  std::map<ex, ex, GiNaC::ex_is_less> by_;  ///< (dB/dx)/B of each symbol x, as far as it is known
};

// Sensitivities whose lines would together be longer than this share them.
constexpr std::size_t longest_unshared = 100'000;

bool has_long_lines(const Derivation& derivation) {
  return derivation.parameters.size() * length_of_definitions(derivation) > longest_unshared;
}

}  // namespace

std::size_t length_of_definitions(const Derivation& derivation) {
  std::size_t length = 0;
  for (const Line& line : derivation.definitions) length += to_text(line.right).size();
  return length;
}

Sensitivities sensitivities(const Derivation& derivation) {
  const AlgebraLock lock;
  const Problem& problem = derivation.problem;
  std::optional<Backwards> backwards;
  std::optional<Chain> chain;
  if (has_long_lines(derivation))
    backwards.emplace(*derivation.model);
  else
    chain.emplace(*derivation.model);
  const ex& velocity = derivation.critical_velocity;
  // The complex R_d stands in moduli that no real fraction has.
  const bool is_nested = !derivation.definitions.empty() || problem->receptance() != nullptr;
  Sensitivities result;
  for (const Symbol& parameter : derivation.parameters) {
    // How a measured receptance or contact changes with omega is in its table, not in symbols.
    if ((problem->receptance() != nullptr || !problem->measured.empty()) &&
        parameter == problem->angular_frequency.symbol)
      continue;
    const ex p = variable(problem, parameter);
    std::optional<ex> fraction;
    if (!is_nested) fraction = logarithmic_derivative(velocity, p);
    result.each.push_back(fraction    ? Sensitivity{parameter, *fraction, {}, {}, {}}
                          : backwards ? backwards->along(parameter, p)
                                      : chain->along(parameter, p));
    result.each.back().derivative = velocity * result.each.back().relative / p;
  }
  if (backwards) result.shared = std::move(backwards->shared);
  return result;
}

}  // namespace vcrit::symbolic
