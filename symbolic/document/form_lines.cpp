#include "document/form_lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>

#include "analysis/dimensionless.hpp"
#include "analysis/rational_form.hpp"
#include "analysis/rational_lines.hpp"
#include "base/errors.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "rules/rulebook.hpp"
#include "shortest/proof.hpp"
#include "shortest/storage_loss.hpp"

namespace vcrit::symbolic {

namespace {

// A text of some 3 MB, printed in a few seconds.
constexpr std::size_t most_terms = 30'000;

/// Z has one line.
bool has_that_line(const std::vector<Line>& lines, const Line& line) {
  return std::any_of(lines.begin(), lines.end(), [&](const Line& known) {
    return known.left.is_equal(line.left) && known.right.is_equal(line.right);
  });
}

std::vector<Line> rational_lines(const Derivation& derivation, double budget) {
  rules::require(rules::Question::rational_form, derivation.problem);
  const RationalForm form = rational_form(*derivation.model, budget, in_ratio(derivation.problem));
  const std::size_t terms = form.square.over.terms() + form.square.under.terms();
  if (terms > most_terms)
    throw ModelError(
        fmt::format("as a rational function of {}^2, v*^2 has {} terms, more than {}: some "
                    "{:.2g} MB of text",
                    printed_name("omega"), terms, most_terms, 1e-4 * static_cast<double>(terms)));
  const std::optional<Swinging> swings = swinging(derivation.problem);
  std::vector<Line> lines = lines_of(form, swings);
  if (const auto ratio = ratio_line(derivation.problem)) lines.insert(lines.begin() + 1, *ratio);
  prove_square(lines.front().right, lines, *derivation.model);
  if (const std::size_t products = products_of_extrema(form); products > most_products_of_extrema) {
    lines.front().words += fmt::format(
        " (the equation for its extrema is left out: {} products of terms, more than {})", products,
        most_products_of_extrema);
    return lines;
  }
  for (Line& line : extrema_lines_of(form, swings))
    if (!has_that_line(lines, line)) lines.push_back(std::move(line));
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

/// What is known of the size of a formula that was not found: the terms of v* multiplied out.
std::string size_words(const Derivation& derivation) {
  if (!rules::answer(rules::Question::rational_form, derivation.problem)) return "";
  return fmt::format("; multiplied out, its polynomials have up to {:.6g} terms",
                     terms_before_squaring(*derivation.model));
}

std::optional<ShortestForm> storage_and_loss(const Derivation& derivation) {
  FoundForm found = proved(find_storage_loss_form(derivation.problem), derivation);
  if (!found.form)
    throw ModelError("no form in storage and loss: " + found.why_none + size_words(derivation));
  return std::move(found.form);
}

std::set<std::string> names_in(const Form& form) {
  std::set<std::string> names;
  if (form.kind == Form::Kind::name) names.insert(form.text);
  for (const std::vector<Form>* parts : {&form.over, &form.under})
    for (const Form& part : *parts) names.merge(names_in(part));
  for (const Signed& term : form.terms) names.merge(names_in(term.form));
  return names;
}

/// In named steps where they fit a page, else in stiffnesses over the reference.
void write_groups(Findings& findings, const Derivation& derivation) {
  const DimensionlessGroups groups = dimensionless_groups(derivation.problem);
  const FoundForm found =
      proved(find_dimensionless_form(derivation.problem, groups), derivation, groups.lines);
  if (!found.form) {
    findings.form_lines = dimensionless_lines(derivation);
    return;
  }
  std::set<std::string> names = names_in(found.form->velocity);
  for (const ShortestForm::Definition& each : found.form->definitions)
    names.merge(names_in(each.meaning));
  for (const Line& group : groups.lines)
    if (names.contains(GiNaC::ex_to<GiNaC::symbol>(group.left).get_name()))
      findings.form_lines.push_back(group);
  if (!findings.form_lines.empty()) findings.form_lines.front().words = "In dimensionless groups";
  findings.in_groups = found.form;
}

}  // namespace

std::vector<Line> extrema_lines(const Derivation& derivation, double budget) {
  const SymbolicModel& model = *derivation.model;
  if (!rules::answer(rules::Question::all_frequencies, derivation.problem) ||
      terms_before_squaring(model) > budget)
    return {};
  std::vector<Line> lines = extrema_lines_of(
      rational_form(model, budget, in_ratio(derivation.problem)), swinging(derivation.problem));
  const auto ratio = ratio_line(derivation.problem);
  if (ratio && !lines.empty()) lines.insert(lines.begin() + 1, *ratio);
  return lines;
}

void write_form(Findings& findings, const Derivation& derivation, const DocumentOptions& options) {
  switch (options.form) {
    case ResultForm::nested:
    case ResultForm::expanded:
      return;
    case ResultForm::storage_loss:
      findings.shortest = storage_and_loss(derivation);
      return;
    case ResultForm::rational:
      findings.form_lines = rational_lines(derivation, options.budget);
      break;
    case ResultForm::dimensionless:
      write_groups(findings, derivation);
      break;
    case ResultForm::shortest:
      break;
  }
  FoundForm found = proved(find_shortest_form(derivation.problem), derivation);
  if (!found.form) findings.why_complex = found.why_none + size_words(derivation);
  findings.shortest = std::move(found.form);
}

}  // namespace vcrit::symbolic
