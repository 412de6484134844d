#include "derivation/loaded.hpp"

#include <algorithm>

#include "derivation/factors.hpp"
#include "derivation/stiffness_forms.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "rules/kinds.hpp"

namespace vcrit::symbolic {

namespace {

// Terms of one line, and elements of a page.
constexpr double readable_terms = 24;
constexpr std::size_t readable_numbers = 96;

const GrowthExponents at_rest_rates{{{"omega"}, -1}};

}  // namespace

Reduction as_at_rest(Reduction reduction) {
  for (Step& step : reduction.steps)
    if (step.kind == Step::Kind::element && !is_rational(step.element))
      step.element = vcrit::at_rest(step.element).value();
  return reduction;
}

bool carries_load(const Problem& problem) {
  return term_count(problem->normal.reduction(), at_rest_rates).power == 0;
}

std::optional<GiNaC::ex> stiffness_at_rest(const Problem& problem) {
  if (!carries_load(problem)) return std::nullopt;
  const Reduction normal = as_at_rest(problem->normal.reduction());
  const TermCount terms = term_count(normal, at_rest_rates).value;
  if (std::max(terms.numerator, terms.denominator) > readable_terms ||
      symbols_of(problem->normal.network()).size() > readable_numbers)
    return std::nullopt;
  const Fraction k = fraction(normal, at_rest_rates).value;
  return factored(k.numerator / k.denominator);
}

std::optional<Line> indentation_line(const Problem& problem) {
  if (!rules::load_is_mean_force(problem)) return std::nullopt;
  const auto stiffness = stiffness_at_rest(problem);
  if (!stiffness) return std::nullopt;
  const GiNaC::ex load = symbol(problem->load->symbol);
  return Line{{"The mean normal force ", load,
               " presses the contact; while that stays closed, its springs carry it"},
              symbol(problem->indentation.symbol),
              factored(load / *stiffness)};
}

}  // namespace vcrit::symbolic
