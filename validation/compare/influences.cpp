#include "compare/influences.hpp"

#include <map>

#include "answers/shares.hpp"
#include "compare/formulas.hpp"
#include "formula/symbols.hpp"
#include "rules/kinds.hpp"

namespace vcrit::validation {

std::vector<Influence> influences(const Problem& problem, const std::vector<ValueLine>& lines) {
  std::vector<Symbol> symbols;
  std::map<Symbol, const ValueLine*> line_of;
  for (const ValueLine& line : lines) {
    symbols.push_back(line.symbol);
    line_of[line.symbol] = &line;
  }
  std::vector<Influence> all;
  for (const Share& share : shares_of(problem, symbols)) {
    const ValueLine& line = *line_of.at(share.of);
    const ShownFormula sign =
        share.is_array ? formula_of(symbolic::symbol(share.called)) : line.name;
    all.push_back({to_text(share.called), sign, line.meaning, share.is_array, share.share});
  }
  return all;
}

std::optional<NormalForce> normal_force(const Problem& problem) {
  const rules::Facts facts(problem);
  const auto mean = static_cast<double>(facts.mean_force());
  if (!(mean > 0)) return std::nullopt;
  return NormalForce{mean, static_cast<double>(facts.oscillating_force())};
}

}  // namespace vcrit::validation
