#include "answering.hpp"

#include <functional>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "program.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::app {

namespace {

using Refusal = std::optional<rules::Answer>;

Refusal refusal_by(rules::Question question, const Problem& problem) {
  const rules::Answer found = rules::answer(question, problem);
  return found ? std::nullopt : std::optional(found);
}

Refusal first_refusal(Refusal one, const std::function<Refusal()>& other) {
  return one ? one : other();
}

Refusal no_motion(const Problem& problem) {
  return refusal_by(rules::motion_question(problem), problem);
}

// v* by Eq. 24, or simulated where that does not hold.
Refusal no_onset(const Problem& problem) {
  problem.values();
  return refusal_by(rules::Question::formula, problem) ? no_motion(problem) : std::nullopt;
}

// A row outside the model holds no number.
Refusal no_row_of_table(const Problem& problem) {
  return first_refusal(no_onset(problem),
                       [&] { return refusal_by(rules::Question::admissible, problem); });
}

Refusal no_comparison(const Problem& problem) {
  return first_refusal(refusal_by(rules::Question::comparison, problem),
                       [&] { return no_motion(problem); });
}

Refusal no_friction(const Problem& problem) {
  return first_refusal(no_motion(problem), [&] { return no_onset(problem); });
}

// For any amplitude, since that may be what is sought.
Refusal no_design(const Problem& problem) {
  const Problem still = problem.with({{problem->amplitude.symbol, 0}});
  return first_refusal(refusal_by(rules::Question::mean_load, still),
                       [&] { return no_motion(still); });
}

Refusal no_evaluator(const Problem& problem) {
  return refusal_by(rules::Question::evaluator, problem);
}

// A report is always written, without the parts that have no answer.
Refusal no_report(const Problem& problem) {
  problem.values();
  return std::nullopt;
}

Refusal no_derivation(const Problem& problem) {
  return refusal_by(rules::Question::derivation, problem);
}

struct CommandRow {
  const char* name;
  Refusal (*refusal)(const Problem&);
  std::vector<std::pair<rules::Question, const char*>> parts = {};  // that it goes on without
};

const std::vector<CommandRow>& command_rows() {
  static const std::vector<CommandRow> rows{
      {"derive", no_derivation},
      {"eval", no_onset},
      {"generate", no_evaluator},
      {"simulate", no_motion},
      {"critical", no_comparison},
      {"plot", no_friction},
      {"sweep", no_row_of_table},
      {"solve", no_design},
      {"validate",
       no_report,
       {{rules::Question::derivation, "the formula"},
        {rules::Question::report_simulation, "the simulation"},
        {rules::Question::report_explorer, "the explorer"},
        {rules::Question::report_stability, "the stability maps"}}}};
  return rows;
}

CommandAnswer answer_by_rulebook(const CommandRow& row, const Problem& problem) {
  CommandAnswer result{row.name};
  try {
    if (const auto found = row.refusal(problem))
      return {row.name, false, with_options(found->reason), with_options(found->advice)};
    for (const auto& [part, words] : row.parts)
      if (const rules::Answer found = rules::answer(part, problem); !found)
        result.left_out.push_back(std::string(words) + ": " + found.reason);
  } catch (const InputError& missing) {
    return {row.name, false, missing.found(), with_options(missing.expected())};
  } catch (const ModelError& unknown) {
    return {row.name, false, unknown.what(), ""};
  }
  return result;
}

}  // namespace

std::vector<CommandAnswer> answering_commands(const Problem& problem) {
  std::vector<CommandAnswer> all;
  for (const CommandRow& row : command_rows()) all.push_back(answer_by_rulebook(row, problem));
  return all;
}

}  // namespace vcrit::app
