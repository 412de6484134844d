#include "document/form_lines.hpp"

#include <fmt/core.h>

#include "analysis/dimensionless.hpp"
#include "analysis/rational_form.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

// A text of some 3 MB, printed in a few seconds.
constexpr std::size_t most_terms = 30'000;

std::vector<Line> extrema_of(const RationalForm& form) {
  const Polynomial slope = stationary(form);
  if (slope.degree("omega") == 0) return {};
  return lines_by_omega(slope, "E", "e",
                        "v* is largest or least, at frequencies besides 0, where E = 0");
}

std::vector<Line> rational_lines(const Derivation& derivation, double budget) {
  rules::require(rules::Question::rational_form, derivation.problem);
  const RationalForm form = rational_form(*derivation.model, budget);
  const std::size_t terms = form.square.over.terms() + form.square.under.terms();
  if (terms > most_terms)
    throw ModelError(
        fmt::format("as a rational function of {}^2, v*^2 has {} terms, more than {}: some "
                    "{:.2g} MB of text",
                    printed_name("omega"), terms, most_terms, 1e-4 * static_cast<double>(terms)));
  std::vector<Line> lines = lines_of(form);
  if (!has_readable_extrema(form)) {
    lines.front().words += " (the equation for its extrema is too long to read)";
    return lines;
  }
  const std::vector<Line> extrema = extrema_of(form);
  lines.insert(lines.end(), extrema.begin(), extrema.end());
  return lines;
}

std::vector<Line> dimensionless_lines(const Derivation& derivation) {
  const DimensionlessForm form = dimensionless(derivation);
  std::vector<Line> lines = form.groups;
  if (!lines.empty()) lines.front().words = "In dimensionless groups";
  if (!form.definitions.empty()) {
    lines.insert(lines.end(), form.definitions.begin(), form.definitions.end());
    lines[form.groups.size()].words = "Stiffnesses over the one that the groups refer to";
  }
  lines.push_back(
      {"In these", quantity("v*"), symbol({"mu0"}) * omega() * symbol({"du_z"}) * form.velocity});
  return lines;
}

}  // namespace

std::vector<Line> extrema_lines(const Derivation& derivation, double budget) {
  const Model& model = *derivation.model;
  if (!rules::answer(rules::Question::all_frequencies, derivation.problem) ||
      terms_before_squaring(model) > budget)
    return {};
  return extrema_of(rational_form(model, budget));
}

std::vector<Line> form_lines(const Derivation& derivation, const DocumentOptions& options) {
  if (options.form == ResultForm::rational) return rational_lines(derivation, options.budget);
  if (options.form == ResultForm::dimensionless) return dimensionless_lines(derivation);
  return {};
}

}  // namespace vcrit::symbolic
