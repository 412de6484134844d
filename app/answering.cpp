#include "answering.hpp"

#include <functional>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::app {

namespace {

using rules::Answer;
using rules::Question;

std::optional<Answer> refusal(Question question, const Problem& problem) {
  const Answer found = rules::answer(question, problem);
  return found ? std::nullopt : std::optional(found);
}

std::optional<Answer> first_of(std::optional<Answer> one,
                               const std::function<std::optional<Answer>()>& other) {
  return one ? one : other();
}

std::optional<Answer> motion(const Problem& problem) {
  return refusal(problem->indenter ? Question::motion_below_indenter : Question::motion, problem);
}

// v* by Eq. 24, or simulated where that does not hold.
std::optional<Answer> onset(const Problem& problem) {
  problem.values();
  return refusal(Question::formula, problem) ? motion(problem) : std::nullopt;
}

// A row outside the model holds no number.
std::optional<Answer> row_of_table(const Problem& problem) {
  return first_of(onset(problem), [&] { return refusal(Question::admissible, problem); });
}

std::optional<Answer> comparison(const Problem& problem) {
  return first_of(refusal(Question::comparison, problem), [&] { return motion(problem); });
}

std::optional<Answer> friction(const Problem& problem) {
  return first_of(motion(problem), [&] { return onset(problem); });
}

// Whatever the amplitude, which may be what is sought.
std::optional<Answer> design(const Problem& problem) {
  const Problem still = problem.with({{problem->amplitude.symbol, 0}});
  return first_of(refusal(Question::mean_load, still),
                  [&] { return refusal(Question::motion, still); });
}

std::optional<Answer> evaluator(const Problem& problem) {
  return refusal(Question::evaluator, problem);
}

// A report shows what there is.
std::optional<Answer> report(const Problem& problem) {
  problem.values();
  return std::nullopt;
}

std::optional<Answer> always(const Problem&) { return std::nullopt; }

struct CommandRow {
  const char* name;
  std::optional<Answer> (*refusal)(const Problem&);
  std::vector<std::pair<Question, const char*>> parts = {};  // that it goes on without
};

const std::vector<CommandRow>& command_rows() {
  static const std::vector<CommandRow> rows{{"derive", always},
                                            {"eval", onset},
                                            {"generate", evaluator},
                                            {"simulate", motion},
                                            {"critical", comparison},
                                            {"plot", friction},
                                            {"sweep", row_of_table},
                                            {"solve", design},
                                            {"validate",
                                             report,
                                             {{Question::report_simulation, "the simulation"},
                                              {Question::report_explorer, "the explorer"},
                                              {Question::report_stability, "the stability maps"}}}};
  return rows;
}

CommandAnswer answer_of(const CommandRow& row, const Problem& problem) {
  CommandAnswer result{row.name};
  try {
    if (const auto found = row.refusal(problem))
      return {row.name, false, found->reason, found->advice};
    for (const auto& [part, words] : row.parts)
      if (const Answer found = rules::answer(part, problem); !found)
        result.left_out.push_back(std::string(words) + ": " + found.reason);
  } catch (const InputError& missing) {
    return {row.name, false, missing.found(), missing.expected()};
  } catch (const ModelError& unknown) {
    return {row.name, false, unknown.what(), ""};
  }
  return result;
}

}  // namespace

std::vector<CommandAnswer> answering_commands(const Problem& problem) {
  std::vector<CommandAnswer> all;
  for (const CommandRow& row : command_rows()) all.push_back(answer_of(row, problem));
  return all;
}

}  // namespace vcrit::app
