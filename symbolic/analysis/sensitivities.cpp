#include "analysis/sensitivities.hpp"

#include <algorithm>
#include <map>

#include "analysis/abbreviated.hpp"
#include "analysis/by_frequency.hpp"
#include "analysis/logarithmic.hpp"
#include "base/interruption.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "formula/real_part.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "network/polynomial.hpp"
#include "polynomial/symbol_ring.hpp"

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

/// What v* is differentiated by, (x/v*) dv*/dx, times what makes it the parameter's.
struct Variable {
  ex x, factor = 1;
};

/// g depends on nu, and v* on nu through g alone: S_nu = (nu/g) dg/dnu S_g.
Variable variable(const Problem& problem, const Symbol& parameter,
                  const std::optional<Line>& ratio) {
  if (!is_poisson(problem, parameter)) return {symbol(parameter)};
  const ex nu = poisson_ratio(parameter);
  if (!ratio) return {nu};
  return {ratio->left, LogarithmicDerivatives(ratio->right).by(nu).value()};
}

/// A factor of the amplitude as people write it: K_n + g (K_d - m omega^2).
ex by_ratio(const ex& factor) { return factor.expand().collect(positive_quantity("g")); }

/// A product of powers of polynomials, one for each exponent.
ex with_powers(const ex& polynomial) {
  const SymbolRing ring({polynomial});
  const FactoredPolynomial found = polynomial_factors(ring.polynomial(polynomial));
  std::map<unsigned long, Polynomial> bases;
  for (const auto& [factor, exponent] : found.factors)
    bases.try_emplace(exponent, ring.ring(), 1).first->second *= factor;
  ex whole = GiNaC::numeric(found.constant.c_str());
  for (const auto& [exponent, base] : bases)
    whole *= GiNaC::pow(factored_polynomial(ring.sum(base)), static_cast<int>(exponent));
  return whole;
}

/// With i as a letter: a spring with a loss factor has it, and polynomials have integer
/// coefficients.
struct ImaginaryUnitAsLetter : GiNaC::map_function {
  const ex letter = quantity("i");

  ex operator()(const ex& expression) override {
    if (!GiNaC::is_a<GiNaC::numeric>(expression)) return expression.map(*this);
    return expression.real_part() + letter * expression.imag_part();
  }
};

/// The shorter of the expression and the same as one fraction.
ex shorter_of(const ex& expression) {
  if (expression.nops() == 0) return expression;
  const std::size_t length = to_text(expression).size();
  if (length > longest_joined_text) return expression;
  ImaginaryUnitAsLetter with_letter;
  const LowestTerms fraction = lowest_terms(with_letter(expression));
  const ex joined = factored_polynomial(fraction.over) / with_powers(fraction.under);
  const ex whole = joined.subs(with_letter.letter == GiNaC::I);
  return to_text(whole).size() < length ? whole : expression;
}

/// The chain rule along the definitions K_1, ..., K_n of a nested formula. With dK_j = p dK_j/dp,
/// S_p = Re(p dB/dp/B), and one more for the omega in v* = omega |B|.
class Chain {
 public:
  Chain(const SymbolicModel& model, const Change& change)
      : stiffnesses_(model.nested_formula().definitions), amplitude_(model.factors(change)) {
    for (const Line& line : stiffnesses_) symbols_.push_back(free_symbols(line.right));
  }

  /// Relative sensitivity and its definitions.
  Sensitivity along(const Symbol& parameter, const ex& x) {
    const bool is_frequency = x.is_equal(omega());
    const Changes changes(is_frequency ? laplace() : x, *this);
    ex sum = 0;
    for (const auto& [factor, exponent] : amplitude_.parts())
      sum += exponent * factored_polynomial(changes.of(factor)) / by_ratio(factor);
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
  Backwards(const SymbolicModel& model, const Change& change) {
    const Factors amplitude = model.factors(change);
    for (const auto& [factor, exponent] : amplitude.parts())
      pass_on(exponent / by_ratio(factor), factor);
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

  Sensitivity along(const Symbol& parameter, const ex& x) const {
    const bool is_frequency = x.is_equal(omega());
    const ex p = is_frequency ? laplace() : x;
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

/// Those of a sum of fractions; what is below their bars is a factor of v*, and stays as it is.
ex numerators_by_frequency(const ex& sum) {
  if (GiNaC::is_a<GiNaC::add>(sum)) {
    ex result = 0;
    for (const ex& term : sum) result += numerators_by_frequency(term);
    return result;
  }
  ex above = 1, below = 1;
  for (const ex& factor : GiNaC::is_a<GiNaC::mul>(sum) ? sum : ex(GiNaC::lst{sum})) {
    const bool divides =
        GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::negative);
    (divides ? below : above) *= factor;
  }
  return factors_by_frequency(above) * below;
}

/// v* as a change writes it, and its sensitivities.
class SensitivitiesIn {
 public:
  SensitivitiesIn(const Derivation& derivation, const Abbreviations& names, const Change& change)
      : derivation_(derivation), ratio_(change.ratio ? names.ratio : std::nullopt) {
    of_chains_.ratio = change.ratio;
    std::vector<Line> letters;  // Z, where v* has it
    if (!change.scale.empty()) letters.push_back(*names.stiffness);
    long_lines_ = has_long_lines(derivation);
    if (!has_fractions(derivation)) return;
    if (!ratio_ && letters.empty())
      velocity_.emplace(derivation.critical_velocity);
    else if (const Formula formula = derivation.model->formula(change).value();
             formula.definitions.empty())
      velocity_.emplace(formula.velocity, letters);
  }

  Sensitivities all() {
    Sensitivities result;
    for (const Symbol& parameter : derivation_.parameters)
      if (has_derivative(parameter)) result.each.push_back(of(parameter));
    if (backwards_) result.shared = std::move(backwards_->shared);
    return result;
  }

  /// The complex R_d stands in moduli that no real fraction has.
  static bool has_fractions(const Derivation& derivation) {
    return derivation.definitions.empty() && derivation.problem->receptance() == nullptr;
  }

 private:
  /// How a measured receptance or contact changes with omega is in its table, not in symbols.
  bool has_derivative(const Symbol& parameter) const {
    const Problem& problem = derivation_.problem;
    return (problem->receptance() == nullptr && problem->measured.empty()) ||
           parameter != problem->angular_frequency.symbol;
  }

  Sensitivity of(const Symbol& parameter) {
    const auto [x, factor] = variable(derivation_.problem, parameter, ratio_);
    const ex p = is_poisson(derivation_.problem, parameter) ? poisson_ratio(parameter) : x;
    std::optional<ex> fraction;
    if (velocity_) fraction = velocity_->by(x);
    Sensitivity result =
        fraction ? Sensitivity{parameter, *fraction, {}, {}, {}} : along(parameter, x);
    if (fraction) result.relative = numerators_by_frequency(result.relative);
    result.relative *= factor;
    result.derivative = derivation_.critical_velocity * result.relative / p;
    return result;
  }

  Sensitivity along(const Symbol& parameter, const ex& x) {
    const SymbolicModel& model = *derivation_.model;
    if (long_lines_) {
      if (!backwards_) backwards_.emplace(model, of_chains_);
      return backwards_->along(parameter, x);
    }
    if (!chain_) chain_.emplace(model, of_chains_);
    return chain_->along(parameter, x);
  }

  const Derivation& derivation_;
  std::optional<Line> ratio_;
  Change of_chains_;  ///< without Z: definitions have the scene's symbols
  std::optional<LogarithmicDerivatives> velocity_;  ///< where it is multiplied out
  bool long_lines_ = false;
  std::optional<Backwards> backwards_;
  std::optional<Chain> chain_;
};

int operations_of_all(const Sensitivities& sensitivities) {
  int sum = 0;
  for (const Sensitivity& each : sensitivities.each) {
    sum += printed_operations(each.relative);
    for (const Line& line : each.changes) sum += printed_operations(line.right);
  }
  return sum;
}

}  // namespace

std::size_t length_of_definitions(const Derivation& derivation) {
  std::size_t length = 0;
  for (const Line& line : derivation.definitions) length += to_text(line.right).size();
  return length;
}

Sensitivities sensitivities(const Derivation& derivation, const Abbreviations& names) {
  const AlgebraLock lock;
  const auto written = [&](const Change& change) {
    return SensitivitiesIn(derivation, names, change).all();
  };
  // Definitions have no k_d for Z, and g is shorter than numbers in any of them.
  if (!SensitivitiesIn::has_fractions(derivation))
    return written(abbreviated({names.ratio, {}}, {}).front());
  return shortest_in(names, {}, written, operations_of_all);
}

}  // namespace vcrit::symbolic
