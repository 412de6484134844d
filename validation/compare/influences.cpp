#include "compare/influences.hpp"

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "base/errors.hpp"
#include "compare/formulas.hpp"
#include "formula/symbols.hpp"
#include "rules/kinds.hpp"

namespace vcrit::validation {

namespace {

/// Less than anyone reads, and more than differences of a simulated v* leave.
constexpr double least_share = 1e-7;

bool belongs_to(const Influence& influence, const Symbol& symbol) {
  return influence.array && symbol.entry > 0 && influence.name == symbol.name;
}

}  // namespace

std::vector<Influence> influences(const Problem& problem, const std::vector<ValueLine>& lines) {
  std::vector<Influence> all;
  try {
    for (const ValueLine& line : lines) {
      const double share = onset_log_derivative(problem, line.symbol);
      const Symbol called = as_called(problem, line.symbol);
      if (!all.empty() && belongs_to(all.back(), called)) {
        all.back().share += share;
        continue;
      }
      const bool array = called.entry > 0;
      const Formula sign = array ? formula_of(symbolic::symbol(Symbol{called.name, 0})) : line.name;
      all.push_back({array ? called.name : to_text(called), sign, line.meaning, array, share});
    }
  } catch (const ModelError&) {
    return {};
  }
  std::erase_if(all, [](const Influence& it) { return !(std::abs(it.share) > least_share); });
  std::stable_sort(all.begin(), all.end(), [](const Influence& a, const Influence& b) {
    return std::abs(a.share) > std::abs(b.share);
  });
  return all;
}

std::optional<NormalForce> normal_force(const Problem& problem) {
  const rules::Facts facts(problem);
  const auto mean = static_cast<double>(facts.mean_force());
  if (!(mean > 0)) return std::nullopt;
  return NormalForce{mean, static_cast<double>(facts.oscillating_force())};
}

}  // namespace vcrit::validation
