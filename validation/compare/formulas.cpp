#include "compare/formulas.hpp"

#include "analysis/limits.hpp"
#include "facts/facts.hpp"
#include "formula/dialect.hpp"
#include "formula/text.hpp"
#include "shortest/proof.hpp"

namespace vcrit::validation {

ShownFormula formula_of(const GiNaC::ex& expression) {
  return {symbolic::to_mathml(expression), symbolic::to_latex(expression),
          symbolic::to_text(expression)};
}

ShownFormula formula_of(const symbolic::Form& form) {
  return {symbolic::to_mathml(form), symbolic::latex_dialect().print({false, form}),
          symbolic::text_dialect().print({false, form})};
}

std::vector<ShownFact> shown_facts(const symbolic::Derivation& derivation) {
  std::vector<ShownFact> shown;
  for (const symbolic::Fact& fact : symbolic::facts(derivation)) {
    shown.push_back({fact.key, fact.words.text(), {}, symbolic::to_mathml(fact.words)});
    for (const auto& [name, meaning] : fact.lines)
      shown.back().lines.push_back({{}, formula_of(name), formula_of(meaning)});
  }
  return shown;
}

ShownVelocity shown_velocity(const symbolic::Derivation& derivation) {
  const auto shortest = symbolic::proved_shortest_form(derivation);
  if (!shortest)
    return {
        formula_of(derivation.critical_velocity), equations_of(derivation.definitions), {}, false};
  ShownVelocity shown{formula_of(shortest->velocity),
                      {},
                      shortest->ratio.text(),
                      true,
                      symbolic::to_mathml(shortest->ratio)};
  for (const auto& [name, meaning] : shortest->definitions)
    shown.definitions.push_back({{}, formula_of(name), formula_of(meaning)});
  return shown;
}

std::vector<ShownEquation> equations_of(const std::vector<symbolic::Line>& lines) {
  std::vector<ShownEquation> equations;
  for (const symbolic::Line& line : lines)
    equations.push_back({line.words.text(), formula_of(line.left), formula_of(line.right),
                         symbolic::to_mathml(line.words)});
  return equations;
}

std::vector<LimitLine> limits_of(const symbolic::Derivation& derivation) {
  std::vector<LimitLine> lines;
  for (const symbolic::Limit& limit : symbolic::limits(derivation))
    lines.push_back({limit.name, limit.equation, symbolic::to_mathml(limit.title),
                     formula_of(limit.result), equations_of(limit.definitions)});
  return lines;
}

}  // namespace vcrit::validation
