#include "analysis/equality.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>

#include "analysis/rational_form.hpp"
#include "analysis/residues.hpp"
#include "base/errors.hpp"
#include "base/numbers.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "problem/variants.hpp"
#include "record/fields.hpp"
#include "record/json_text.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::record {

void fields(Fields& f, const symbolic::Equality::Counterexample& it) {
  f.group("values", [&it](Fields& values) {
    for (const auto& [symbol, value] : it.values) values(to_text(symbol).c_str(), value);
  });
  f("first", it.first)("second", it.second)("relative_difference", it.difference);
}

void fields(Fields& f, const symbolic::Equality& it) {
  const bool all_symbols = it.scope == symbolic::Equality::Scope::symbols;
  const bool proved = it.evidence == symbolic::Equality::Evidence::canonical_form;
  f("equal", it.equal)("scope", all_symbols ? "symbols" : "values");
  f.when(it.equal, "evidence", proved ? "canonical form" : "residues");
  f.when(it.equal, "chance_of_error", it.chance_of_error).some("counterexample", it.counterexample);
}

}  // namespace vcrit::record

namespace vcrit::symbolic {

namespace {

// Formulas up to this size are brought to their canonical form in a moment.
constexpr double terms_to_prove_by = 300;

constexpr std::uint64_t points = 4;

using Decimals = std::map<std::string, GiNaC::numeric>;

/// The decimal as it was typed with a unit, which may have more digits than a double.
GiNaC::numeric written_decimal(const Problem& problem, const Symbol& symbol, double value) {
  const TypedNumber* const typed =
      problem->typed == nullptr ? nullptr : problem->typed->find(symbol);
  const bool holds = typed != nullptr && typed->value == value && !typed->decimal.empty();
  return holds ? exact_decimal(typed->decimal) : exact_decimal(value);
}

/// The decimals of elements and mass; nothing if one is missing.
std::optional<Decimals> decimals(const Problem& problem) {
  Decimals result;
  for (const auto& [symbol, value] : elements_with_values(problem)) {
    if (!value) return std::nullopt;
    result[to_text(symbol)] = written_decimal(problem, symbol, *value);
  }
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
      isotropic != nullptr && !isotropic->quantity.value)
    return std::nullopt;
  for (const auto& mass : {problem->mass, problem->mount_mass}) {
    if (!mass) continue;
    if (!mass->value) return std::nullopt;
    result[to_text(mass->symbol)] = written_decimal(problem, mass->symbol, *mass->value);
  }
  return result;
}

/// Where a scene's symbols have their decimals; the others stay where they are.
ResiduePoint at_decimals(const ResiduePoint& point, const Decimals& values) {
  return [&point, &values](const std::string& symbol) {
    const auto found = values.find(symbol);
    return found == values.end() ? point(symbol) : Residue(found->second);
  };
}

/// Whether both agree at all points where neither divides by 0.
bool agree(const SymbolicModel& a, const Decimals& a_values, const SymbolicModel& b,
           const Decimals& b_values) {
  std::uint64_t compared = 0;
  for (std::uint64_t number = 0; compared < points; ++number) {
    const ResiduePoint point = named_point(number);
    const auto first = square_at(a, at_decimals(point, a_values));
    const auto second = square_at(b, at_decimals(point, b_values));
    if (!first || !second) continue;
    ++compared;
    if (!(*first == *second)) return false;
  }
  return true;
}

bool small(const Problem& problem, const SymbolicModel& model) {
  return rules::answer(rules::Question::rational_form, problem) &&
         terms_before_squaring(model) <= terms_to_prove_by;
}

/// What is the same at all points, proved where it can be.
Equality equal(Equality::Scope scope, bool proved, const SymbolicModel& a, const SymbolicModel& b) {
  Equality result;
  result.equal = true;
  result.scope = scope;
  if (proved) return result;
  result.evidence = Equality::Evidence::residues;
  result.chance_of_error = std::pow(chance_of_agreement(a, b), points);
  return result;
}

std::set<Symbol> compared_symbols(const Problem& problem, bool with_elements) {
  std::set<Symbol> result{problem->coefficient.symbol, problem->angular_frequency.symbol,
                          problem->amplitude.symbol};
  if (!with_elements) return result;
  for (const Symbol& symbol : *problem->elements) result.insert(symbol);
  if (problem->mass) result.insert(problem->mass->symbol);
  if (problem->mount_mass) result.insert(problem->mount_mass->symbol);
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential))
    if (!isotropic->quantity.value) result.insert(isotropic->quantity.symbol);
  return result;
}

/// With numbers for what is compared, as far as it has that. v* does not depend on the indentation
/// or the load.
Problem with_numbers(const Problem& problem, const Values& values) {
  Values own{{pressing(problem).symbol, 1}};
  const auto add = [&](const Symbol& symbol) {
    if (const double* const found = values.find(symbol)) own.emplace(symbol, *found);
  };
  for (const Symbol& symbol : *problem->elements) add(symbol);
  for (const Quantity& quantity : quantities(problem)) add(quantity.symbol);
  return problem.with(own);
}

/// Small numbers for the symbols; Poisson's ratio among them needs to be below 1/2.
Values small_numbers(const std::set<Symbol>& symbols, std::uint64_t point) {
  Values result;
  for (const Symbol& symbol : symbols)
    result[symbol] = static_cast<double>(named_point(point)(to_text(symbol)).value() % 19 + 1) / 40;
  return result;
}

// Two different functions of few numbers differ nearly everywhere, mostly by a lot; doubles show
// differences far smaller than this.
constexpr double clear_difference = 1e-3, shown_by_doubles = 1e-12;

/// An angular frequency of the table.
double within(const Receptance& receptance, std::uint64_t point) {
  const double share = static_cast<double>(point % 8) / 8;
  return receptance.rows.front().omega +
         share * (receptance.rows.back().omega - receptance.rows.front().omega);
}

/// A measured drive is its table, whatever the file's name.
void refuse_two_tables(const Problem& a, const Problem& b) {
  const Receptance *first = a->receptance(), *second = b->receptance();
  if (first != nullptr && second != nullptr && first->rows != second->rows)
    throw ModelError(
        "the two drives are measured, by different tables: compare their numbers by vcrit sweep");
}

/// Values at a point of that number.
Values values_at(std::uint64_t point, const std::set<Symbol>& symbols, Equality::Scope scope,
                 const Problem& a, const Problem& b) {
  auto values = small_numbers(symbols, point);
  // Elements with values of their own show their difference somewhere over these decades.
  if (scope == Equality::Scope::values)
    values[a->angular_frequency.symbol] *= std::pow(10, point % 16);
  for (const Problem* problem : {&a, &b})
    if (const Receptance* measured = (*problem)->receptance())
      values[(*problem)->angular_frequency.symbol] = within(*measured, point);
  return values;
}

constexpr std::uint64_t tried_points = 64;

/// By the names that one of the scenes gives the symbols.
std::vector<std::pair<Symbol, double>> called_by_scenes(const Values& values, const Problem& a,
                                                        const Problem& b) {
  std::vector<std::pair<Symbol, double>> all;
  for (const auto& [symbol, value] : values)
    all.emplace_back(as_called(a->names.contains(symbol.name) ? a : b, symbol), value);
  return all;
}

/// A ratio has the name that its scene gives it, and is the same by any.
Problem with_ratio_of(const Problem& a, const Problem& b) {
  const auto* ratio = std::get_if<Isotropic>(&a->tangential);
  const auto* other = std::get_if<Isotropic>(&b->tangential);
  if (ratio == nullptr || other == nullptr || ratio->by != other->by) return b;
  if (ratio->quantity.value || other->quantity.value) return b;
  const Symbol& symbol = ratio->quantity.symbol;
  const bool is_element = std::ranges::find(*b->elements, symbol) != b->elements->end();
  return is_element ? b : with_isotropic(b, *ratio);
}

Equality different(Equality::Scope scope, const Problem& a, const Problem& b) {
  Equality result;
  result.scope = scope;
  std::set<Symbol> symbols = compared_symbols(a, scope == Equality::Scope::symbols);
  symbols.merge(compared_symbols(b, scope == Equality::Scope::symbols));
  double largest = shown_by_doubles;
  for (std::uint64_t point = 0; point < tried_points && largest < clear_difference; ++point) {
    const auto values = values_at(point, symbols, scope, a, b);
    const double first = critical_velocity(with_numbers(a, values));
    const double second = critical_velocity(with_numbers(b, values));
    const double difference = std::abs(first - second) / std::max(first, second);
    if (!(difference > largest)) continue;
    largest = difference;
    result.counterexample = {called_by_scenes(values, a, b), first, second, difference};
  }
  // What doubles do not show, a few thousand bits do.
  for (std::uint64_t point = 0; point < tried_points && !result.counterexample; ++point) {
    const auto values = values_at(point, symbols, scope, a, b);
    const Problem first = with_numbers(a, values), second = with_numbers(b, values);
    if (const double difference = certified_difference(first, second); difference > 0)
      result.counterexample = {called_by_scenes(values, a, b), critical_velocity(first),
                               critical_velocity(second), difference};
  }
  return result;
}

}  // namespace

Equality compare(const Problem& a, const Problem& other) {
  const AlgebraLock lock;
  const Problem b = with_ratio_of(a, other);
  using Scope = Equality::Scope;
  refuse_two_tables(a, b);
  for (const Problem* problem : {&a, &b})
    rules::require(rules::Question::formula_of_all_values, *problem);
  const SymbolicModel first(a), second(b);
  if (agree(first, {}, second, {})) {
    const bool proved = small(a, first) && small(b, second) &&
                        canonical_text(rational_form(first, terms_to_prove_by)) ==
                            canonical_text(rational_form(second, terms_to_prove_by));
    return equal(Scope::symbols, proved, first, second);
  }
  const auto values = decimals(a), others = decimals(b);
  if (!values || !others) return different(Scope::symbols, a, b);
  if (!agree(first, *values, second, *others)) return different(Scope::values, a, b);
  const bool proved =
      a->receptance() == nullptr && canonical_text(rational_form(first, *values)) ==
                                        canonical_text(rational_form(second, *others));
  return equal(Scope::values, proved, first, second);
}

std::string text_of(const Equality& comparison) {
  const bool symbols = comparison.scope == Equality::Scope::symbols;
  std::string text = comparison.equal ? "equal: " : "different: ";
  text += symbols ? "v* as a function of all symbols" : "v* with the elements' values put in";
  if (comparison.equal && comparison.evidence == Equality::Evidence::canonical_form)
    return text + "; both have one canonical form\n";
  if (comparison.equal)
    return text + "; the same residues at " + std::to_string(points) +
           " points, by chance with less than " + to_text(comparison.chance_of_error) + "\n";
  if (!comparison.counterexample) return text + "\n";
  text += "; where\n";
  for (const auto& [symbol, value] : comparison.counterexample->values)
    text += "    " + to_text(symbol) + " = " + to_text(value) + "\n";
  const auto& [values, first, second, difference] = *comparison.counterexample;
  text += "v* is " + to_text(first) + " m/s and " + to_text(second) + " m/s\n";
  if (difference < shown_by_doubles)
    text += fmt::format("which differ by {:.2g} of themselves\n", difference);
  return text;
}

std::string json_of(const Equality& comparison) {
  return record::json_text(record::json_of(comparison), 2) + "\n";
}

}  // namespace vcrit::symbolic
