#include "report/material_page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analysis/retardation.hpp"
#include "analysis/rheology.hpp"
#include "analysis/sensitivities.hpp"
#include "base/rounded.hpp"
#include "compare/formulas.hpp"
#include "derivation/derivation.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "network/masses.hpp"
#include "report/document.hpp"
#include "report/material.hpp"
#include "report/network_drawing.hpp"
#include "report/records.hpp"
#include "shortest/storage_loss.hpp"

namespace vcrit::validation::report {

namespace {

using GiNaC::ex;
using symbolic::Fraction;
using symbolic::Leading;
using symbolic::Line;

// Terms of a part that is multiplied out for its spectrum.
constexpr double most_terms_of_part = 100;

// Of a stiffness at rest or at once: more are no formula that one reads, and those of a grid of
// springs and dampers take minutes.
constexpr double most_terms_of_end = 1000;

// Bytes of limits, which are as long as v* each.
constexpr double largest_limits = 10e6;

/// Two limits a symbol, of which MathML has up to twenty characters for one of text.
double size_of_limits(const symbolic::Derivation& derivation) {
  return 2.0 * 20.0 * static_cast<double>(derivation.parameters.size()) *
         static_cast<double>(symbolic::length_of_definitions(derivation));
}

/// One of the scene's networks.
struct Material {
  std::string id, heading, name;  ///< "normal", "Normal contact", "K_n"
  const ReducedNetwork* network;
};

std::vector<Material> materials_of(const Problem& problem) {
  std::vector<Material> found{{"normal", "Normal contact", "K_n", &problem->normal}};
  if (const auto* own = std::get_if<ReducedNetwork>(&problem->tangential))
    found.push_back({"tangential", "Tangential contact", "K_t", own});
  if (const ReducedNetwork* drive = problem->drive_network())
    found.push_back({"drive", "Drive", "K_d", drive});
  return found;
}

record::Json shown(const ex& expression) { return record::page_of(formula_of(expression)); }

/// K(s) as power of s and the leading coefficient, for omega to 0 (-1) or infinity (1); nothing
/// where it has more terms than one reads.
std::optional<std::pair<int, ex>> leading_term(const Network& network, int direction) {
  const symbolic::GrowthExponents rates{{{"omega"}, direction}};
  const Reduction reduction = reduce(network);
  const symbolic::TermCount terms = symbolic::term_count(reduction, rates).value;
  if (std::max(terms.numerator, terms.denominator) > most_terms_of_end) return std::nullopt;
  const Leading<Fraction> k = symbolic::fraction(reduction, rates);
  const ex coefficient = (k.value.numerator / k.value.denominator).subs(symbolic::laplace() == 1);
  return std::pair{k.power * direction, coefficient.normal()};
}

record::Json ends_record(const Network& network) {
  record::Json ends = record::Json::array();
  const auto add = [&](const char* words, const ex& value) {
    ends.push_back({{"words", words}, {"formula", shown(value)}});
  };
  const auto low = leading_term(network, -1), high = leading_term(network, 1);
  if (low && low->first == 0) add("Equilibrium stiffness K(0)", low->second);
  if (low && low->first == 1) add("Viscosity of steady flow", low->second);
  if (high && high->first == 0) add("Glassy stiffness K(∞)", high->second);
  if (high && high->first == 1) add("Direct damper", high->second);
  return ends;
}

/// Whether spectra may be looked for: parts side by side or one behind the other, each small.
bool has_small_parts(const Network& network) {
  const auto small = [](const Network& part) {
    const symbolic::TermCount terms = symbolic::term_count(reduce(part), {}).value;
    return std::max(terms.numerator, terms.denominator) <= most_terms_of_part;
  };
  if (const auto* parallel = std::get_if<Parallel>(&network.form))
    return std::all_of(parallel->parts.begin(), parallel->parts.end(), small);
  return small(network);
}

bool is_small_series(const Network& network) {
  const symbolic::TermCount terms = symbolic::term_count(reduce(network), {}).value;
  const auto* series = std::get_if<Series>(&network.form);
  if (series != nullptr)
    return std::all_of(series->parts.begin(), series->parts.end(), has_small_parts);
  return std::max(terms.numerator, terms.denominator) <= most_terms_of_part;
}

/// Lines that say more than their name.
record::Json lines_record(const std::vector<std::pair<Line, Line>>& pairs) {
  std::vector<Line> lines;
  for (const auto& [first, second] : pairs)
    for (const Line& line : {first, second})
      if (!line.left.is_equal(line.right)) lines.push_back(line);
  return record::page_of(equations_of(lines));
}

record::Json relaxation_record(const Network& network) {
  const auto spectrum = has_small_parts(network) ? symbolic::spectrum(network) : std::nullopt;
  if (!spectrum) return nullptr;
  const ex t = symbolic::positive_quantity("t");
  ex force = spectrum->equilibrium;
  std::vector<std::pair<Line, Line>> pairs;
  for (const auto& [time, strength] : spectrum->lines) {
    force += strength.left * GiNaC::exp(-t / time.left);
    pairs.emplace_back(time, strength);
  }
  record::Json result{
      {"sum", shown(spectrum->sum())}, {"function", shown(force)}, {"lines", lines_record(pairs)}};
  result["impulse"] = spectrum->damper.is_zero() ? record::Json() : shown(spectrum->damper);
  return result;
}

record::Json retardation_record(const Network& network) {
  const auto spectrum =
      is_small_series(network) ? symbolic::retardation_spectrum(network) : std::nullopt;
  if (!spectrum) return nullptr;
  const ex t = symbolic::positive_quantity("t");
  ex displacement = spectrum->glassy + spectrum->fluidity * t;
  std::vector<std::pair<Line, Line>> pairs;
  for (const auto& [time, compliance] : spectrum->lines) {
    displacement += compliance.left * (1 - GiNaC::exp(-t / time.left));
    pairs.emplace_back(time, compliance);
  }
  return {{"sum", shown(spectrum->sum())},
          {"function", shown(displacement)},
          {"lines", lines_record(pairs)}};
}

/// Values of all elements of the network, or none.
std::optional<Values> values_of(const Problem& problem, const Network& network) {
  Values values;
  for (const Symbol& symbol : symbols_of(network)) {
    const double* const found = problem.known_values().find(symbol);
    if (found == nullptr) return std::nullopt;
    values[symbol] = *found;
  }
  return values;
}

/// Below an indenter the contact's networks are moduli of the half-space.
MaterialUnits units_of(const Problem& problem, const Material& material) {
  if (problem->indenter && material.network != problem->drive_network())
    return {"Pa", "Pa.s", true};
  return {};
}

record::Json words_unless_none(double value, const std::string& words) {
  return value == 0 ? record::Json() : record::Json{{"words", words}};
}

record::Json numbers_record(const MaterialNumbers& numbers, const MaterialUnits& units,
                            const std::string& id) {
  const auto& [relaxation, retardation] = numbers;
  record::Json branches = record::Json::array(), delays = record::Json::array();
  for (const MaxwellBranch& each : relaxation.branches)
    branches.push_back(
        {{"time", each.time}, {"strength", rounded(each.stiffness, units.stiffness)}});
  for (const KelvinUnit& each : retardation.units)
    delays.push_back(
        {{"time", each.time}, {"compliance", inverse_words(each.compliance, units.stiffness)}});
  record::Json figures = record::Json::array();
  for (figures::Figure& figure : material_figures(numbers, units)) {
    figure.name = id + "_" + figure.name;
    figures.push_back(record::page_of(figure));
  }
  return {
      {"equilibrium",
       words_unless_none(relaxation.equilibrium, rounded(relaxation.equilibrium, units.stiffness))},
      {"damper", words_unless_none(relaxation.damper, rounded(relaxation.damper, units.damper))},
      {"branches", branches},
      {"glassy",
       words_unless_none(retardation.glassy, inverse_words(retardation.glassy, units.stiffness))},
      {"fluidity",
       words_unless_none(retardation.fluidity, inverse_words(retardation.fluidity, units.damper))},
      {"units", delays},
      {"figures", figures}};
}

record::Json storage_record(const Problem& problem, const Material& material) {
  const auto found = symbolic::storage_and_loss_of(problem, *material.network, material.name);
  if (!found) return nullptr;
  record::Json steps = record::Json::array();
  for (const auto& [name, meaning] : found->steps)
    steps.push_back(record::page_of(ShownEquation{{}, formula_of(name), formula_of(meaning)}));
  const auto is_short = [&](const symbolic::Form& part) {
    return std::none_of(found->steps.begin(), found->steps.end(),
                        [&](const auto& step) { return step.name.text == part.text; });
  };
  record::Json result{{"steps", steps},
                      {"storage_is_short", is_short(found->storage)},
                      {"loss_is_short", is_short(found->loss)},
                      {"storage", record::page_of(formula_of(found->storage))},
                      {"loss", record::page_of(formula_of(found->loss))}};
  result["loss_factor"] =
      found->loss_factor ? record::page_of(formula_of(*found->loss_factor)) : record::Json();
  return result;
}

record::Json material_record(const Problem& problem, const Material& material) {
  const Network& network = material.network->network();
  std::vector<Line> inside;
  const ex k = symbolic::nested(material.network->reduction(), {}, inside).value;
  record::Json result{{"id", material.id},
                      {"heading", material.heading},
                      {"drawing", record::page_of(Picture{draw(network), material.heading})},
                      {"stiffness", shown(k)},
                      {"inside", record::page_of(equations_of(inside))},
                      {"parts", storage_record(problem, material)},
                      {"relaxes", of_springs_and_dampers(network)},
                      {"masses", has_masses(network)}};
  if (!of_springs_and_dampers(network)) return result;
  result["ends"] = ends_record(network);
  result["relaxation"] = relaxation_record(network);
  result["retardation"] = retardation_record(network);
  const std::optional<Values> values = values_of(problem, network);
  result["numbers"] = values ? numbers_record(material_numbers(network, *values),
                                              units_of(problem, material), material.id)
                             : record::Json();
  return result;
}

}  // namespace

std::string material_page(const Problem& problem) {
  const symbolic::AlgebraLock lock;
  const symbolic::NamesOfScene names(problem);
  const symbolic::Derivation derivation = symbolic::derive(problem);
  const std::string& title = problem->source->title;
  const std::string heading = title.empty() ? "Networks of the scene" : title;
  record::Json page{{"version", VCRIT_VERSION},
                    {"heading", heading},
                    {"indenter", problem->indenter.has_value()},
                    {"measured", problem->receptance() != nullptr},
                    {"materials", record::Json::array()},
                    {"facts", record::page_of(shown_facts(derivation))}};
  for (const Material& material : materials_of(problem))
    page["materials"].push_back(material_record(problem, material));
  page["velocity"] = record::page_of(shown_velocity(derivation));
  page["velocity"]["equation"] = derivation.equation;
  const double size = size_of_limits(derivation);
  const bool fit = size <= largest_limits;
  const std::vector<LimitLine> limits = fit ? limits_of(derivation) : std::vector<LimitLine>();
  page["size_of_limits"] = nullptr;
  if (!fit) page["size_of_limits"] = fmt::format("{:.2g} MB", 1e-6 * size);
  page["limits"] = record::page_of(limits);
  page["many_limits"] = limits.size() > shown_limits;
  return document("material", page, {heading, true, {}});
}

}  // namespace vcrit::validation::report
