#include "compare/values.hpp"

#include "base/errors.hpp"
#include "compare/formulas.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "network/number_words.hpp"

namespace vcrit::validation {

namespace {

struct ValueKind {
  const char* unit;
  std::string meaning;
};

/// What a number is beside what every number of its role is.
const char* place_of(const Element& element) {
  switch (element.kind) {
    case ElementKind::mass:
      return " in the drive";
    case ElementKind::maxwell:
      return " of a Maxwell branch";
    case ElementKind::measured:
      return " of the measured contact";
    case ElementKind::spring:
    case ElementKind::damper:
    case ElementKind::lossy:
      return "";
  }
  throw Bug("an element without a place");
}

// Below an indenter that of the half-space's elements is another than that of the drive's.
Dimension dimension_of(const Problem& problem, const Symbol& symbol, NumberRole role) {
  const NumberRow& row = number_row(role);
  if (!problem->indenter) return row.dimension;
  const auto& settable = problem->source->settable;
  const auto known = settable.find(to_text(as_called(problem, symbol)));
  return known == settable.end() ? row.in_half_space : known->second;
}

std::map<Symbol, ValueKind> kinds_of_elements(const Problem& problem) {
  std::map<Symbol, ValueKind> kinds;
  for_each_element(problem, [&](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
      kinds[symbol] = {si_unit(dimension_of(problem, symbol, role)),
                       std::string(number_words(element, symbol, role)) + place_of(element)};
    });
  });
  return kinds;
}

}  // namespace

std::vector<ValueLine> value_lines(const Problem& problem) {
  const Values& values = problem.values();
  std::vector<ValueLine> lines;
  const auto add = [&](const Symbol& symbol, const ValueKind& kind) {
    const ShownFormula name = formula_of(symbolic::symbol(symbol));
    lines.push_back({symbol, name, values.at(symbol), kind.unit, kind.meaning});
  };
  add(problem->angular_frequency.symbol, {"rad/s", "angular frequency"});
  add(problem->amplitude.symbol,
      {"m", problem->mount ? "amplitude of the vibrator" : "amplitude of the normal oscillation"});
  if (problem->load)
    add(problem->load->symbol, {"N", "mean normal force"});
  else
    add(problem->indentation.symbol, {"m", "mean indentation"});
  add(problem->coefficient.symbol, {"", "coefficient of friction"});
  if (problem->mass) add(problem->mass->symbol, {"kg", "mass of the body"});
  if (problem->mount_mass &&
      (!problem->mass || problem->mass->symbol != problem->mount_mass->symbol))
    add(problem->mount_mass->symbol, {"kg", "mass that moves with the contact"});
  if (problem->indenter)
    for (const Quantity& size : problem->indenter->sizes)
      add(size.symbol,
          {si_unit(problem->source->settable.at(size.symbol.name)), "size of the indenter"});
  const auto kinds = kinds_of_elements(problem);
  for (const Symbol& symbol : *problem->elements)
    if (const auto kind = kinds.find(symbol); kind != kinds.end()) add(symbol, kind->second);
  return lines;
}

const Isotropic* given_ratio(const Problem& problem) {
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic == nullptr) return nullptr;
  const std::string name = to_text(as_called(problem, isotropic->quantity.symbol));
  return problem->source->settable.contains(name) ? isotropic : nullptr;
}

}  // namespace vcrit::validation
