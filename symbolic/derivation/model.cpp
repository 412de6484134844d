#include "derivation/model.hpp"

#include <algorithm>
#include <limits>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "derivation/factors.hpp"
#include "formula/prose.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Formulas with more terms in one polynomial than this are not multiplied out: nobody reads them.
constexpr double readable_formula_terms = 24;

// "First the dampers to zero, then the drive to rigid": a rate that beats every other.
constexpr int much_faster = 1000;

/// The leading part of a polynomial whose symbols go with the given powers.
Leading<ex> leading_part(const ex& polynomial, const std::map<std::string, int>& powers) {
  const ex expanded = polynomial.expand();
  const auto power_of = [&](const ex& term) {
    int power = 0;
    for (const auto& [name, rate] : powers)
      power += rate * term.degree(name == "m" || name == "m_n" ? symbol({name}) : quantity(name));
    return power;
  };
  if (!GiNaC::is_a<GiNaC::add>(expanded)) return {power_of(expanded), expanded};
  Leading<ex> leading{std::numeric_limits<int>::min(), 0};
  for (const ex& term : expanded) {
    const int power = power_of(term);
    if (power > leading.power) leading = {power, 0};
    if (power == leading.power) leading.value += term;
  }
  return leading;
}

bool is_readable_count(const TermCount& count) {
  return std::max(count.numerator, count.denominator) <= readable_formula_terms;
}

bool has_quantity(const ex& expression, const std::string& name) {
  return expression.has(quantity(name));
}

Fraction scaled_fraction(const Fraction& k, const GiNaC::exmap& scale) {
  return {k.numerator.subs(scale), k.denominator.subs(scale)};
}

bool is_constant(const Fraction& k) {
  return !k.numerator.has(laplace()) && !k.denominator.has(laplace());
}

bool is_kelvin(const Fraction& k) {
  return !k.numerator.has(omega()) && !k.denominator.has(laplace()) &&
         k.numerator.degree(laplace()) == 1 && k.numerator.ldegree(laplace()) == 0;
}

// Of K(0) in what the rates change: 0 of what carries a load, below 0 of what does no longer.
int power_at_rest(const ReducedNetwork& network, GrowthExponents rates) {
  for (auto& [symbol, rate] : rates) rate *= much_faster;
  rates[{"omega"}] = -1;
  return term_count(network.reduction(), rates).power;
}

bool same_scale(const GiNaC::exmap& a, const GiNaC::exmap& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.first.is_equal(other.first) && one.second.is_equal(other.second);
  });
}

bool same_factors(const Change& a, const Change& b) {
  return a.rigid == b.rigid && a.ratio.has_value() == b.ratio.has_value() &&
         (!a.ratio || a.ratio->is_equal(*b.ratio)) && same_scale(a.scale, b.scale);
}

Surrounding surrounding_of(const Problem& problem) {
  using NormalMass = Surrounding::NormalMass;
  const bool mass = problem->mass.has_value();
  const NormalMass normal = !problem->mount_mass                      ? NormalMass::none
                            : problem->mount_mass->symbol.name == "m" ? NormalMass::body
                                                                      : NormalMass::own;
  return {!problem->rigid(), mass, problem->mount.has_value(), normal};
}

}  // namespace

ex isotropic_ratio(const Isotropic& isotropic) {
  const bool poisson = isotropic.by == Isotropic::By::poisson;
  const Quantity& given = isotropic.quantity;
  const ex number = given.value ? ex(exact_decimal(*given.value))
                    : poisson   ? poisson_ratio(given.symbol)
                                : symbol(given.symbol);
  return poisson ? 2 * (1 - number) / (2 - number) : number;
}

Symbols free_symbols(const ex& expression) {
  Symbols symbols;
  for (auto part = expression.preorder_begin(); part != expression.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part)) symbols.insert(*part);
  return symbols;
}

std::vector<Line> used_in(const ex& formula, std::vector<Line> definitions) {
  Symbols needed = free_symbols(formula);
  std::vector<Line> used;
  for (auto line = definitions.rbegin(); line != definitions.rend(); ++line) {
    hear_interruption();
    if (!needed.contains(line->left)) continue;
    needed.merge(free_symbols(line->right));
    used.push_back(std::move(*line));
  }
  std::reverse(used.begin(), used.end());
  return used;
}

SymbolicModel::SymbolicModel(const Problem& problem)
    : surrounding_(surrounding_of(problem)), balance_(solve_balance(surrounding_)) {
  networks_.push_back({"K_n", problem->normal});
  loaded_ = power_at_rest(problem->normal, {}) == 0;
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential)) {
    ratio_ = symbolic::isotropic_ratio(*isotropic);
    const Quantity& ratio = isotropic->quantity;
    Prose words("Isotropic contact");
    if (isotropic->by == Isotropic::By::poisson) {
      const ex nu = ratio.value ? quantity("nu") : poisson_ratio(ratio.symbol);
      words +=
          {", ", stated(quantity("K_t") / quantity("K_n"), 2 * (1 - nu) / (2 - nu)), " (Mindlin)"};
      if (ratio.value) words += {" with ", stated_number(nu, *ratio.value)};
    }
    identities_.push_back({words, quantity("K_t"), *ratio_ * quantity("K_n")});
  } else {
    networks_.push_back({"K_t", std::get<ReducedNetwork>(problem->tangential)});
  }
  std::visit(Overloaded{[](const Rigid&) {}, [&](const ReducedNetwork& drive) { put_drive(drive); },
                        [&](const Receptance&) {
                          identities_.push_back(
                              {{"The drive is measured: ", quantity("R_d"),
                                ", its receptance, is interpolated in a table over ", omega()},
                               quantity("K_d"),
                               1 / quantity("R_d")});
                        }},
             problem->drive);
  if (problem->mount) networks_.push_back({"K_m", *problem->mount});
}

/// The same network as another is no third one.
void SymbolicModel::put_drive(const ReducedNetwork& drive) {
  for (const NamedNetwork& part : networks_)
    if (drive.network() == part.network.network()) {
      identities_.push_back(
          {"The drive is the same network", quantity("K_d"), quantity(part.name)});
      return;
    }
  networks_.push_back({"K_d", drive});
}

const Factors& SymbolicModel::factors(const Change& change) const {
  for (const auto& [known, factors] : factors_)
    if (same_factors(known, change)) return factors;
  return factors_.emplace_back(change, new_factors(change)).second;
}

Factors SymbolicModel::new_factors(const Change& change) const {
  ex amplitude = balance_.contact_amplitude;
  if (change.ratio) amplitude = amplitude.subs(quantity("K_t") == *change.ratio * quantity("K_n"));
  // A drive that grows is no longer the contact's network.
  for (const Line& identity : identities_)
    if (!change.rigid || !identity.left.is_equal(quantity("K_d")))
      amplitude = amplitude.subs(identity.left == identity.right);
  amplitude = amplitude.subs(change.scale);
  Factors result;
  if (!has_mount()) {
    result.multiply_rational(factored(amplitude));
    return result;
  }
  result.multiply_product(amplitude);
  result.cancel();
  return result;
}

ex SymbolicModel::amplitude(const Change& change) const { return factors(change).value(); }

const ex& SymbolicModel::per_friction() const {
  if (!per_friction_) per_friction_ = (amplitude({}) / symbol({"mu0"}) / symbol({"du_z"})).normal();
  return *per_friction_;
}

bool SymbolicModel::is_small(const ex& amplitude, const Change& change) const {
  double largest = 0, sum = 0, product = 1;
  for (std::size_t i = 0; i < networks_.size(); ++i) {
    if (!has_quantity(amplitude, networks_[i].name)) continue;
    const TermCount count = counts(change.rates)[i].value;
    largest = std::max({largest, count.numerator, count.denominator});
    // K_t + K_d - m omega^2 over one denominator.
    sum = sum * count.denominator + product * count.numerator;
    product *= count.denominator;
  }
  const bool joint = (surrounding_.drive && !change.rigid) || surrounding_.mount;
  const bool inertia =
      surrounding_.mass || surrounding_.normal_mass != Surrounding::NormalMass::none;
  return std::max(largest, joint ? sum + (inertia ? product : 0) : 0) <= readable_formula_terms;
}

const std::vector<Leading<TermCount>>& SymbolicModel::counts(const GrowthExponents& rates) const {
  if (counted_.second.empty() || counted_.first != rates) {
    counted_ = {rates, {}};
    for (const NamedNetwork& part : networks_)
      counted_.second.push_back(term_count(part.network.reduction(), rates));
  }
  return counted_.second;
}

std::map<std::string, int> SymbolicModel::powers(const Change& change) const {
  std::map<std::string, int> powers;
  for (std::size_t i = 0; i < networks_.size(); ++i)
    powers[networks_[i].name] = counts(change.rates)[i].power;
  if (change.rigid) powers["K_d"] += much_faster;
  if (change.massless) powers["m"] = -1;
  const auto frequency = change.rates.find({"omega"});
  if (frequency != change.rates.end()) powers["s"] = frequency->second;
  return powers;
}

// The normal force has a mean, which a network with K_n(0) = 0 cannot carry, nor a mount. A scene
// without such a network loses nothing.
bool SymbolicModel::unloads_contact(const Change& change) const {
  if (has_mount() && power_at_rest(networks_.back().network, change.rates) < 0) return true;
  return loaded_ && power_at_rest(networks_.front().network, change.rates) != 0;
}

Leading<Factors> SymbolicModel::leading_amplitude(const std::map<std::string, int>& powers,
                                                  const Change& change) const {
  const auto changes = [](const auto& each) { return each.second != 0; };
  if (std::none_of(powers.begin(), powers.end(), changes)) return {0, factors(change)};
  if (!change.keeps_letters()) return new_leading_amplitude(powers, change);
  const auto [known, is_new] = leading_.try_emplace({powers, change.rigid});
  if (is_new) known->second = new_leading_amplitude(powers, change);
  return known->second;
}

Leading<Factors> SymbolicModel::new_leading_amplitude(const std::map<std::string, int>& powers,
                                                      const Change& change) const {
  const Factors& whole = factors(change);
  Leading<Factors> leading;
  leading.value.multiply_rational(whole.coefficient());
  for (const auto& [factor, exponent] : whole.parts()) {
    const Leading<ex> part = leading_part(factor, powers);
    leading.power += exponent * part.power;
    for (int i = 0; i < std::abs(exponent); ++i)
      leading.value.multiply(part.value, exponent > 0 ? 1 : -1);
  }
  leading.value.cancel();
  return leading;
}

std::optional<Formula> SymbolicModel::formula(const Change& change) const {
  std::map<std::string, int> powers = this->powers(change);
  if (powers["K_n"] != 0 || powers["K_t"] < 0 || powers["K_d"] < 0 || powers["K_m"] < 0)
    return std::nullopt;
  if (unloads_contact(change)) return std::nullopt;
  const Leading<Factors> leading = leading_amplitude(powers, change);
  if (leading.power != 0) return std::nullopt;
  const Factors& amplitude = leading.value;
  if (!is_small(amplitude.value(), change)) return nested_in(amplitude, change);
  const std::map<std::string, Fraction> fractions = this->fractions(change);
  return Formula{omega() * multiplied_out(amplitude, fractions).modulus(),
                 {},
                 equation(fractions, powers, change)};
}

std::optional<Factors> SymbolicModel::multiplied_out_amplitude(const Change& change) const {
  const Factors amplitude = leading_amplitude({}, change).value;
  if (!is_small(amplitude.value(), change)) return std::nullopt;
  return multiplied_out(amplitude, fractions(change));
}

Formula SymbolicModel::nested_formula() const {
  return nested_in(leading_amplitude({}, {}).value, {});
}

Asymptotic SymbolicModel::asymptotic(int direction, Change change) const {
  change.rates[{"omega"}] = direction;
  const Leading<Factors> leading = leading_amplitude(powers(change), change);
  const ex amplitude = leading.value.value();
  const int power = leading.power * direction;
  if (is_small(amplitude, change))
    return {power, multiplied_out(leading.value, fractions(change)).value(), {}};
  return {power, amplitude, definitions(amplitude, change)};
}

std::map<std::string, Fraction> SymbolicModel::fractions(const Change& change) const {
  if (!fractions_ || fractions_->first != change.rates) {
    fractions_.emplace(change.rates, std::map<std::string, Fraction>());
    for (std::size_t i = 0; i < networks_.size(); ++i)
      if (is_readable_count(counts(change.rates)[i].value))
        fractions_->second[networks_[i].name] =
            fraction(networks_[i].network.reduction(), change.rates).value;
  }
  std::map<std::string, Fraction> scaled = fractions_->second;
  if (!change.scale.empty())
    for (auto& [name, k] : scaled) k = scaled_fraction(k, change.scale);
  return scaled;
}

Factors SymbolicModel::multiplied_out(const Factors& amplitude,
                                      const std::map<std::string, Fraction>& fractions) const {
  GiNaC::exmap put;
  for (const auto& [name, k] : fractions) put[quantity(name)] = k.numerator / k.denominator;
  Factors whole;
  whole.multiply_rational(amplitude.coefficient());
  for (const auto& [factor, exponent] : amplitude.parts())
    whole.multiply_rational(GiNaC::pow(factor.subs(put), exponent));
  whole.cancel();
  return whole;
}

Formula SymbolicModel::nested_in(const Factors& amplitude, const Change& change) const {
  const ex velocity = omega() * amplitude.modulus();
  return {velocity, definitions(velocity, change), ""};
}

std::vector<Line> SymbolicModel::definitions(const ex& formula, const Change& change) const {
  std::vector<Line> lines;
  for (const auto& [name, network] : networks_) {
    if (!has_quantity(formula, name)) continue;
    const ex k = nested(network.reduction(), change.rates, lines).value;
    lines.push_back({"", quantity(name), k});
  }
  for (Line& line : lines) line.right = line.right.subs(change.scale);
  return lines;
}

std::optional<GiNaC::exmap> SymbolicModel::multiplied_out(const ex& expression,
                                                          const Change& change) const {
  if (!is_small(expression, change)) return std::nullopt;
  GiNaC::exmap put;
  for (const auto& [name, k] : fractions(change))
    if (has_quantity(expression, name)) put[quantity(name)] = k.numerator / k.denominator;
  return put;
}

std::string SymbolicModel::equation(const std::map<std::string, Fraction>& networks,
                                    const std::map<std::string, int>& powers,
                                    const Change& change) const {
  const auto grows = [&](const char* name) {
    const auto found = powers.find(name);
    return found != powers.end() && found->second > 0;
  };
  if (grows("K_t") || surrounding_.mount) return "";
  const bool isotropic = ratio_ || change.ratio;
  // A network too large to be multiplied out is none of the special cases.
  const auto holds_for = [&](const char* name, bool (*holds)(const Fraction&)) {
    const auto found = networks.find(name);
    return found != networks.end() && holds(found->second);
  };
  const auto both = [&](bool (*holds)(const Fraction&)) {
    return holds_for("K_n", holds) && (isotropic || holds_for("K_t", holds));
  };
  if (grows("K_d") || !surrounding_.drive) return both(is_constant) ? "(31)" : "";
  const auto drive = networks.find("K_d");
  const bool elastic_with_mass = surrounding_.mass && !change.massless && drive != networks.end() &&
                                 is_constant(drive->second);
  if (!elastic_with_mass) return "";
  if (both(is_constant)) return "(30)";
  if (!both(is_kelvin)) return "";
  return isotropic ? "(29)" : "(27)";
}

}  // namespace vcrit::symbolic
