#include "formulas.hpp"

#include "analysis/limits.hpp"
#include "formula/text.hpp"

namespace vcrit::validation {

Formula formula_of(const GiNaC::ex& expression) {
  return {symbolic::to_mathml(expression), symbolic::to_latex(expression),
          symbolic::to_text(expression)};
}

std::vector<Equation> equations_of(const std::vector<symbolic::Line>& lines) {
  std::vector<Equation> equations;
  for (const symbolic::Line& line : lines)
    equations.push_back({line.words, formula_of(line.left), formula_of(line.right)});
  return equations;
}

std::vector<LimitLine> limits_of(const symbolic::Derivation& derivation) {
  std::vector<LimitLine> lines;
  for (const symbolic::Limit& limit : symbolic::limits(derivation))
    lines.push_back({limit.name, limit.equation, limit.mathml_name, formula_of(limit.result),
                     equations_of(limit.definitions)});
  return lines;
}

}  // namespace vcrit::validation
