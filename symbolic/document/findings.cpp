#include "document/findings.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analysis/expanded.hpp"
#include "analysis/half_space.hpp"
#include "analysis/residues.hpp"
#include "analysis/separation.hpp"
#include "base/errors.hpp"
#include "document/form_lines.hpp"
#include "formula/dialect.hpp"
#include "formula/text.hpp"
#include "rules/rulebook.hpp"
#include "shortest/proof.hpp"

namespace vcrit::symbolic {

namespace {

// Terms in v* up to which the equation for its extrema is short enough to be shown unasked.
constexpr double readable_extrema = 8;

// What is asked of every element of a nested formula is about as long as the formula, each time: as
// many characters of text are printed in a few seconds.
constexpr std::size_t most_characters = 10'000'000;

// All of them together, in definitions of v*, as measured: five as text, twenty in JSON, which has
// LaTeX and the derivatives besides.
constexpr std::size_t lengths_of_sensitivities = 24;

/// Of a document for one of text, as measured: MathML has a tag for each name and sign.
std::size_t characters_for_one(Format format) {
  switch (format) {
    case Format::text:
    case Format::system:
      return 1;
    case Format::latex:
    case Format::markdown:
      return 2;
    case Format::json:
      return 5;
    case Format::html:
      break;
  }
  return 16;
}

void refuse_large(const Derivation& derivation, std::size_t formulas, const char* what) {
  const std::size_t length = length_of_definitions(derivation);
  if (formulas * length > most_characters)
    throw ModelError(fmt::format(
        "v* of {} symbols has {} as long as itself: some {:.2g} MB of text, more than {:.2g}",
        derivation.parameters.size(), what, 1e-6 * static_cast<double>(formulas * length),
        1e-6 * static_cast<double>(most_characters)));
}

Derivation shown_derivation(const Derivation& derivation, const DocumentOptions& options) {
  if (options.form == ResultForm::nested) return nested_form(derivation);
  if (options.form != ResultForm::expanded) return derivation;
  const Derivation expanded = expanded_form(derivation, options.budget);
  if (derivation.problem->receptance() == nullptr)
    prove(expanded.critical_velocity, *derivation.model);
  return expanded;
}

/// Z of the result, where it has one, is the drive's real stiffness: a name has one meaning.
Abbreviations names_beside(const std::optional<ShortestForm>& form, const Derivation& derivation) {
  Abbreviations names = abbreviations(derivation);
  if (!form || !names.stiffness) return names;
  const std::string meaning = to_text(names.stiffness->right),
                    name = form_of(names.stiffness->left).form.text;
  for (const ShortestForm::Definition& each : form->definitions)
    if (each.name.text == name && text_dialect().print({false, each.meaning}) != meaning)
      names.stiffness.reset();
  return names;
}

}  // namespace

Findings findings_of(const Problem& problem, const DocumentOptions& options) {
  const Derivation derivation = derive(problem);
  Findings findings{shown_derivation(derivation, options),
                    fingerprint(*derivation.model),
                    options.form,
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    rules::answer(rules::Question::motion_in_time, problem).reason,
                    {},
                    {},
                    {},
                    {},
                    facts(derivation)};
  write_form(findings, derivation, options);
  findings.abbreviated.names = names_beside(findings.shortest, derivation);
  const std::size_t symbols = findings.derivation.parameters.size();
  const std::size_t each = characters_for_one(options.format);
  if (options.limits) refuse_large(findings.derivation, 2 * each * symbols, "limits");
  if (options.sensitivities)
    refuse_large(findings.derivation, std::max(lengths_of_sensitivities, 5 * each),
                 "sensitivities");
  if (problem->indenter) findings.half_space = half_space_lines(derivation);
  if (problem->separation) findings.separation = separation_lines(derivation);
  if (options.limits) {
    Findings::Abbreviated& abbreviated = findings.abbreviated;
    findings.limits = limits(derivation, abbreviated.names);
    findings.asymptotes = asymptotes(derivation);
    abbreviated.asymptotes = asymptotes(derivation, abbreviated.names);
    findings.resonances = resonances(derivation);
    abbreviated.resonances = resonances(derivation, abbreviated.names);
    if (options.form != ResultForm::rational)
      findings.extrema = extrema_lines(derivation, readable_extrema);
  }
  if (options.sensitivities) {
    if (options.format == Format::json)
      findings.sensitivities = sensitivities(derivation);
    else
      findings.abbreviated.sensitivities = sensitivities(derivation, findings.abbreviated.names);
  }
  return findings;
}

}  // namespace vcrit::symbolic
