#include "compare/influences.hpp"

#include <map>
#include <optional>

#include "answers/shares.hpp"
#include "compare/formulas.hpp"
#include "compare/values.hpp"
#include "formula/symbols.hpp"
#include "rules/kinds.hpp"

namespace vcrit::validation {

namespace {

/// The number that an isotropic contact has beside those of its networks.
std::optional<ValueLine> line_of_ratio(const Problem& problem) {
  const Isotropic* isotropic = given_ratio(problem);
  if (isotropic == nullptr) return std::nullopt;
  using symbolic::quantity;
  const bool poisson = isotropic->by == Isotropic::By::poisson;
  const GiNaC::ex sign = poisson ? quantity("nu") : quantity("K_t") / quantity("K_n");
  return ValueLine{isotropic->quantity.symbol, formula_of(sign), *isotropic->quantity.value, "",
                   poisson ? "Poisson's ratio" : "tangential over normal stiffness"};
}

}  // namespace

std::vector<Influence> influences(const Problem& problem, std::vector<ValueLine> lines) {
  if (const auto ratio = line_of_ratio(problem)) lines.push_back(*ratio);
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
