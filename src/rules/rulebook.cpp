#include "rules/rulebook.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "normal/mount.hpp"
#include "rules/cells.hpp"

namespace vcrit::rules {

namespace {

/// The amplitude (m) at which (3) or (4) would be broken.
double closed_below(const Facts& facts) {
  const Problem& problem = facts.problem();
  const double indentation = facts.indentation();
  const long double oscillating = facts.oscillating_force();
  if (!(oscillating > 0)) return indentation;
  const long double amplitude = facts.value(problem->amplitude);
  const auto by_force = static_cast<double>(amplitude / oscillating * facts.mean_force());
  if (problem->mount) return by_force;  // |K_n| is nowhere below K_n(0)
  return std::min(indentation, by_force);
}

// Under a load the depth depends on the amplitude, and may be one above the surface.
std::string what_keeps_it_closed(const Facts& facts) {
  const double amplitude = closed_below(facts);
  if (amplitude > 0) return "an amplitude below " + rounded_down(amplitude, "m");
  return fmt::format("a smaller amplitude or a larger {}",
                     facts.problem()->load ? "load" : "indentation");
}

/// What makes the mean force of a closed contact.
std::string load_words(const Problem& problem) {
  const std::string name = name_in(problem, pressing(problem));
  return load_is_mean_force(problem) ? name : "K_n(0) " + name;
}

std::string filled(const std::string& pattern, const Facts& facts) {
  if (pattern.find('{') == std::string::npos) return pattern;
  const Problem& problem = facts.problem();
  const auto oscillating = static_cast<double>(facts.oscillating_force()),
             mean = static_cast<double>(facts.mean_force());
  const auto [oscillating_words, mean_words] = rounded_apart(oscillating, mean, "N");
  const auto [amplitude_words, indentation_words] =
      rounded_apart(contact_amplitude(problem), facts.indentation(), "m");
  return fmt::format(
      fmt::runtime(pattern),
      fmt::arg("du_z", problem->mount ? "du_z" : name_in(problem, problem->amplitude)),
      fmt::arg("u_z0", name_in(problem, problem->indentation)),
      fmt::arg("mu0", name_in(problem, problem->coefficient)),
      fmt::arg("amplitude", amplitude_words), fmt::arg("indentation", indentation_words),
      fmt::arg("load", load_words(problem)), fmt::arg("oscillating", oscillating_words),
      fmt::arg("mean", mean_words), fmt::arg("what_keeps_it_closed", what_keeps_it_closed(facts)),
      fmt::arg("share", rounded(oscillating / mean, "")));
}

// Each that is not yes, by the order of kinds.
template <class Use>
void for_each_refusal(Question question, const Facts& facts, const Use& use) {
  for (std::size_t i = 0; i < kinds; ++i) {
    const auto kind = static_cast<SceneKind>(i);
    if (table_entry(question, kind).verdict == Ruling::yes || !facts.is(kind)) continue;
    Answer found = cell(question, kind);
    found.reason = filled(found.reason, facts);
    found.advice = filled(found.advice, facts);
    if (!use(found)) return;
  }
}

}  // namespace

Answer cell(Question question, SceneKind kind) {
  const Cell& found = table_entry(question, kind);
  return {found.verdict, found.reason, found.advice, name_of(kind)};
}

Answer answer(Question question, const Problem& problem) {
  Answer result;
  for_each_refusal(question, Facts(problem), [&](const Answer& first) {
    result = first;
    return false;
  });
  return result;
}

Question motion_question(const Problem& problem) {
  return cells_move(problem) ? Question::motion_below_indenter : Question::motion;
}

std::vector<std::string> reasons(Question question, const Problem& problem) {
  std::vector<std::string> all;
  for_each_refusal(question, Facts(problem), [&](const Answer& each) {
    all.push_back(each.reason);
    return true;
  });
  return all;
}

void require(Question question, const Problem& problem, const std::string& asker) {
  const Answer found = answer(question, problem);
  if (!found) throw ModelError(asker + found.reason, found.advice);
}

const char* name_of(Question question) {
  switch (question) {
    case Question::admissible:
      return "admissible";
    case Question::formula:
      return "formula";
    case Question::closed_form:
      return "closed_form";
    case Question::formula_of_all_values:
      return "formula_of_all_values";
    case Question::evaluator:
      return "evaluator";
    case Question::rational_form:
      return "rational_form";
    case Question::all_frequencies:
      return "all_frequencies";
    case Question::motion:
      return "motion";
    case Question::motion_below_indenter:
      return "motion_below_indenter";
    case Question::normal_motion:
      return "normal_motion";
    case Question::motion_in_time:
      return "motion_in_time";
    case Question::comparison:
      return "comparison";
    case Question::other_methods:
      return "other_methods";
    case Question::report_simulation:
      return "report_simulation";
    case Question::report_explorer:
      return "report_explorer";
    case Question::report_stability:
      return "report_stability";
    case Question::mean_load:
      return "mean_load";
    case Question::closed_range:
      return "closed_range";
    case Question::closed_amplitude:
      return "closed_amplitude";
    case Question::derivation:
      return "derivation";
  }
  throw Bug("a question without a name");
}

}  // namespace vcrit::rules
