#include "analysis/abbreviations.hpp"

#include <algorithm>

#include "analysis/abbreviated.hpp"
#include "analysis/rational_lines.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/form.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

}  // namespace

std::vector<Line> Abbreviations::used_by(const std::vector<GiNaC::ex>& expressions) const {
  std::vector<Line> used;
  for (const std::optional<Line>* line : {&ratio, &stiffness})
    if (*line && std::any_of(expressions.begin(), expressions.end(),
                             [&](const ex& each) { return each.has((*line)->left); }))
      used.push_back(**line);
  return used;
}

Abbreviations abbreviations(const Derivation& derivation) {
  const AlgebraLock lock;
  Abbreviations result;
  // Without a drive v* has g in front, and nothing else.
  if (derivation.model->has_drive()) result.ratio = ratio_line(derivation.problem);
  if (const auto swings = swinging(derivation.problem))
    result.stiffness =
        Line{"", real_quantity("Z"),
             symbol({swings->spring}) - symbol({swings->mass}) * GiNaC::pow(omega(), 2)};
  return result;
}

std::vector<Change> abbreviated(const Abbreviations& names, const Change& change) {
  // A ratio of its own is that of another contact.
  const bool ratio = names.ratio && !change.ratio;
  std::vector<Change> all;
  for (const bool with_stiffness : {true, false})
    for (const bool with_ratio : {true, false}) {
      if ((with_stiffness && !names.stiffness) || (with_ratio && !ratio)) continue;
      all.push_back(change);
      if (with_ratio) all.back().ratio = 1 / names.ratio->left;
      if (!with_stiffness) continue;
      // k_d = Z + m omega^2 = Z - m s^2
      const ex &z = names.stiffness->left, &meaning = names.stiffness->right;
      const ex inertia = -meaning.coeff(omega(), 2), spring = meaning.coeff(omega(), 0);
      all.back().scale[spring] = z - inertia * GiNaC::pow(laplace(), 2);
    }
  return all;
}

int printed_operations(const GiNaC::ex& expression) {
  return operations_in(form_of(expression).form);
}

}  // namespace vcrit::symbolic
