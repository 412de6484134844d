#include "analysis/asymptotes.hpp"

#include "analysis/abbreviated.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "formula/prose.hpp"
#include "formula/symbols.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

/// K_n as L_n: without its power of s it is no longer a stiffness.
GiNaC::exmap coefficient_names(const std::vector<Line>& definitions) {
  GiNaC::exmap names{{laplace(), 1}};
  for (const Line& line : definitions) {
    std::string name = base_name(GiNaC::ex_to<GiNaC::symbol>(line.left).get_name());
    names[line.left] = quantity(name.replace(0, 1, "L"));
  }
  return names;
}

// Leading terms are powers of s with positive factors, which s = 1 leaves.
Asymptote asymptote(const SymbolicModel& model, bool high, const Abbreviations& abbreviated) {
  const Asymptotic amplitude = shortest_in(
      abbreviated, {},
      [&](const Change& change) { return model.asymptotic(high ? 1 : -1, change); },
      [](const Asymptotic& each) { return printed_operations(each.amplitude); });
  const GiNaC::exmap names = coefficient_names(amplitude.definitions);
  const Prose title{tends(omega(), high)};
  Asymptote result{high, title.text(), title, amplitude.power + 1, amplitude.amplitude.subs(names),
                   {}};
  if (is_negative(result.coefficient)) result.coefficient = -result.coefficient;
  for (const Line& line : amplitude.definitions)
    result.definitions.push_back({line.words, line.left.subs(names), line.right.subs(names)});
  return result;
}

}  // namespace

std::vector<Asymptote> asymptotes(const Derivation& derivation, const Abbreviations& names) {
  const AlgebraLock lock;
  if (!rules::answer(rules::Question::all_frequencies, derivation.problem)) return {};
  const SymbolicModel& model = *derivation.model;
  // Z has no leading term that is short: that of m omega^2 alone is none of its own.
  const Abbreviations ratio{names.ratio, {}};
  return {asymptote(model, false, ratio), asymptote(model, true, ratio)};
}

}  // namespace vcrit::symbolic
