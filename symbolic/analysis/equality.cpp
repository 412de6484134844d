#include "analysis/equality.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
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
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

// Formulas up to this size are brought to their canonical form in a moment.
constexpr double terms_to_prove_by = 300;

constexpr std::uint64_t points = 4;

using Decimals = std::map<std::string, GiNaC::numeric>;

/// The decimals of elements and mass; nothing if one is missing.
std::optional<Decimals> decimals(const Scene& scene) {
  Decimals result;
  for (const auto& [symbol, value] : scene.elements) {
    if (!value) return std::nullopt;
    result[to_text(symbol)] = exact_decimal(*value);
  }
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
      isotropic != nullptr && !isotropic->quantity.value)
    return std::nullopt;
  if (!scene.mass) return result;
  if (!scene.mass->value) return std::nullopt;
  result["m"] = exact_decimal(*scene.mass->value);
  return result;
}

/// Where a scene's symbols have their decimals; the others stay where they are.
Point at_decimals(const Point& point, const Decimals& values) {
  return [&point, &values](const std::string& symbol) {
    const auto found = values.find(symbol);
    return found == values.end() ? point(symbol) : Residue(found->second);
  };
}

/// Whether both agree at all points where neither divides by 0.
bool agree(const Model& a, const Decimals& a_values, const Model& b, const Decimals& b_values) {
  std::uint64_t compared = 0;
  for (std::uint64_t number = 0; compared < points; ++number) {
    const Point point = named_point(number);
    const auto first = square_at(a, at_decimals(point, a_values));
    const auto second = square_at(b, at_decimals(point, b_values));
    if (!first || !second) continue;
    ++compared;
    if (!(*first == *second)) return false;
  }
  return true;
}

bool small(const Model& model) {
  bool rational = !model.per_friction().has(quantity("R_d"));
  for (const Part& part : model.networks()) rational = rational && is_rational(part.network);
  return rational && terms_before_squaring(model) <= terms_to_prove_by;
}

/// What is the same at all points, proved where it can be.
Comparison equal(Comparison::Scope scope, bool proved, const Model& a, const Model& b) {
  Comparison result;
  result.equal = true;
  result.scope = scope;
  if (proved) return result;
  result.evidence = Comparison::Evidence::residues;
  result.chance_of_error = std::pow(chance_of_agreement(a, b), points);
  return result;
}

/// The scene with numbers for what has none, and all of its numbers.
class Filled {
 public:
  Filled(const Scene& scene, const std::map<Symbol, double>& values) : scene_(scene) {
    const auto set = [&values](Quantity& quantity) {
      if (const auto found = values.find(quantity.symbol); found != values.end())
        quantity.value = found->second;
    };
    for (auto& [symbol, value] : scene_.elements)
      if (const auto found = values.find(symbol); found != values.end()) value = found->second;
    if (auto* isotropic = std::get_if<Isotropic>(&scene_.tangential)) set(isotropic->quantity);
    if (scene_.mass) set(*scene_.mass);
    for (Quantity* each : {&scene_.coefficient, &scene_.angular_frequency, &scene_.amplitude})
      set(*each);
    scene_.indentation.value = 1;  // v* does not depend on it
  }
  double critical_velocity() const { return vcrit::critical_velocity(scene_); }
  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
};

std::set<Symbol> compared_symbols(const Scene& scene, bool with_elements) {
  std::set<Symbol> result{scene.coefficient.symbol, scene.angular_frequency.symbol,
                          scene.amplitude.symbol};
  if (!with_elements) return result;
  for (const auto& [symbol, value] : scene.elements) result.insert(symbol);
  if (scene.mass) result.insert(scene.mass->symbol);
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    if (!isotropic->quantity.value) result.insert(isotropic->quantity.symbol);
  return result;
}

/// Small numbers for the symbols; Poisson's ratio among them needs to be below 1/2.
std::map<Symbol, double> small_numbers(const std::set<Symbol>& symbols, std::uint64_t point) {
  std::map<Symbol, double> result;
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
void refuse_two_tables(const Scene& a, const Scene& b) {
  if (a.receptance && b.receptance && a.receptance->rows != b.receptance->rows)
    throw ModelError(
        "the two drives are measured, by different tables: compare their numbers by vcrit sweep");
}

/// Values at a point of that number.
std::map<Symbol, double> values_at(std::uint64_t point, const std::set<Symbol>& symbols,
                                   Comparison::Scope scope, const Scene& a, const Scene& b) {
  auto values = small_numbers(symbols, point);
  // Elements with values of their own show their difference somewhere over these decades.
  if (scope == Comparison::Scope::values)
    values[a.angular_frequency.symbol] *= std::pow(10, point % 16);
  for (const Scene* scene : {&a, &b})
    if (scene->receptance)
      values[scene->angular_frequency.symbol] = within(*scene->receptance, point);
  return values;
}

constexpr std::uint64_t tried_points = 64;

/// By the names that one of the scenes gives the symbols.
std::vector<std::pair<Symbol, double>> called_by_scenes(const std::map<Symbol, double>& values,
                                                        const Scene& a, const Scene& b) {
  std::vector<std::pair<Symbol, double>> all;
  for (const auto& [symbol, value] : values)
    all.emplace_back(as_called(a.names.contains(symbol.name) ? a : b, symbol), value);
  return all;
}

/// A ratio has the name that its scene gives it, and is the same by any.
Scene with_ratio_of(const Scene& a, Scene b) {
  const auto* ratio = std::get_if<Isotropic>(&a.tangential);
  auto* other = std::get_if<Isotropic>(&b.tangential);
  if (ratio == nullptr || other == nullptr || ratio->by != other->by) return b;
  if (ratio->quantity.value || other->quantity.value) return b;
  const Symbol& symbol = ratio->quantity.symbol;
  const bool is_element = std::any_of(b.elements.begin(), b.elements.end(),
                                      [&](const auto& each) { return each.first == symbol; });
  if (!is_element) other->quantity.symbol = symbol;
  return b;
}

Comparison different(Comparison::Scope scope, const Scene& a, const Scene& b) {
  Comparison result;
  result.scope = scope;
  std::set<Symbol> symbols = compared_symbols(a, scope == Comparison::Scope::symbols);
  symbols.merge(compared_symbols(b, scope == Comparison::Scope::symbols));
  double largest = shown_by_doubles;
  for (std::uint64_t point = 0; point < tried_points && largest < clear_difference; ++point) {
    const auto values = values_at(point, symbols, scope, a, b);
    const double first = Filled(a, values).critical_velocity();
    const double second = Filled(b, values).critical_velocity();
    const double difference = std::abs(first - second) / std::max(first, second);
    if (!(difference > largest)) continue;
    largest = difference;
    result.counterexample = {called_by_scenes(values, a, b), first, second, difference};
  }
  // What doubles do not show, a few thousand bits do.
  for (std::uint64_t point = 0; point < tried_points && !result.counterexample; ++point) {
    const auto values = values_at(point, symbols, scope, a, b);
    const Filled first(a, values), second(b, values);
    if (const double difference = certified_difference(first.scene(), second.scene());
        difference > 0)
      result.counterexample = {called_by_scenes(values, a, b), first.critical_velocity(),
                               second.critical_velocity(), difference};
  }
  return result;
}

}  // namespace

Comparison compare(const Scene& a, const Scene& other) {
  const AlgebraLock lock;
  const Scene b = with_ratio_of(a, other);
  using Scope = Comparison::Scope;
  refuse_two_tables(a, b);
  for (const Scene* scene : {&a, &b})
    rules::require(rules::Question::formula_of_all_values, *scene);
  const Model first(a), second(b);
  if (agree(first, {}, second, {})) {
    const bool proved = small(first) && small(second) &&
                        canonical_text(rational_form(first, terms_to_prove_by)) ==
                            canonical_text(rational_form(second, terms_to_prove_by));
    return equal(Scope::symbols, proved, first, second);
  }
  const auto values = decimals(a), others = decimals(b);
  if (!values || !others) return different(Scope::symbols, a, b);
  if (!agree(first, *values, second, *others)) return different(Scope::values, a, b);
  const bool proved = !a.receptance && canonical_text(rational_form(first, *values)) ==
                                           canonical_text(rational_form(second, *others));
  return equal(Scope::values, proved, first, second);
}

std::string text_of(const Comparison& comparison) {
  const bool symbols = comparison.scope == Comparison::Scope::symbols;
  std::string text = comparison.equal ? "equal: " : "different: ";
  text += symbols ? "v* as a function of all symbols" : "v* with the elements' values put in";
  if (comparison.equal && comparison.evidence == Comparison::Evidence::canonical_form)
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

std::string json_of(const Comparison& comparison) {
  const bool symbols = comparison.scope == Comparison::Scope::symbols;
  nlohmann::ordered_json out{{"equal", comparison.equal},
                             {"scope", symbols ? "symbols" : "values"}};
  if (comparison.equal) {
    const bool canonical = comparison.evidence == Comparison::Evidence::canonical_form;
    out["evidence"] = canonical ? "canonical form" : "residues";
    out["chance_of_error"] = comparison.chance_of_error;
  } else if (comparison.counterexample) {
    nlohmann::ordered_json values;
    for (const auto& [symbol, value] : comparison.counterexample->values)
      values[to_text(symbol)] = value;
    out["counterexample"] = {{"values", values},
                             {"first", comparison.counterexample->first},
                             {"second", comparison.counterexample->second},
                             {"relative_difference", comparison.counterexample->difference}};
  }
  return out.dump(2) + "\n";
}

}  // namespace vcrit::symbolic
