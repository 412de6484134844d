#include "accuracy/evaluator_errors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "accuracy/cells.hpp"
#include "accuracy/front.hpp"
#include "critical/conditioning.hpp"
#include "critical/critical_velocity.hpp"

namespace vcrit::validation::accuracy {

namespace {

constexpr std::size_t most_worst = 10;  // rows of a table that is seen at one glance
constexpr double wrong =
    1e-10;  // more digits than anyone measures: what is nearer needs no explanation

template <class Visit>
void for_each_set(const Problem& problem, const Inputs& inputs, const Visit& visit) {
  for (const std::vector<double>& set : inputs.sets) {
    Values values;
    for (std::size_t j = 0; j < set.size(); ++j) values[inputs.symbols[j]] = set[j];
    visit(problem.with(values));
  }
}

/// The library's function, which reads a scene's numbers each time.
WayAnswers library_answers(const Problem& problem, const Inputs& inputs) {
  using Clock = std::chrono::steady_clock;
  WayAnswers answers{{"library", "Eq. 24 in doubles, from the scene"}, 0, {}};
  const Clock::time_point begin = Clock::now();
  for_each_set(problem, inputs,
               [&](const Problem& each) { answers.values.push_back(critical_velocity(each)); });
  answers.nanoseconds = std::chrono::duration<double, std::nano>(Clock::now() - begin).count() /
                        static_cast<double>(inputs.sets.size());
  return answers;
}

struct Failures {
  std::size_t not_finite = 0, unexplained = 0;
  double worst_unexplained = 0;  ///< relative

  void add(double found, double right, double condition) {
    if (!std::isfinite(found)) {
      ++not_finite;
      return;
    }
    const double relative = std::abs(found - right) / std::abs(right);
    if (!(relative > wrong) || relative <= formula_tolerance(condition)) return;
    ++unexplained;
    worst_unexplained = std::max(worst_unexplained, relative);
  }
  std::string words() const {
    std::string text;
    if (not_finite > 0) text = fmt::format("{} values are not finite", not_finite);
    if (unexplained > 0)
      text +=
          fmt::format("{}{} values are off by up to {:.1e}, which conditioning does not explain",
                      text.empty() ? "" : "; ", unexplained, worst_unexplained);
    return text;
  }
};

// What is not finite comes first.
std::vector<WorstInput> worst_inputs(const WayAnswers& answers, const Inputs& inputs,
                                     const VelocityReference& reference,
                                     const std::vector<double>& errors) {
  const auto rank = [&](std::size_t i) { return std::isnan(errors[i]) ? HUGE_VAL : errors[i]; };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (std::isfinite(reference.right[i]) && rank(i) > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
  order.resize(std::min(order.size(), most_worst));
  std::vector<WorstInput> result;
  for (const std::size_t i : order)
    result.push_back({inputs.sets[i], answers.values[i], reference.right[i], errors[i]});
  return result;
}

}  // namespace

VelocityReference reference_of(const Problem& problem, const Inputs& inputs) {
  VelocityReference reference;
  for_each_set(problem, inputs, [&](const Problem& each) {
    reference.right.push_back(certified_or_nan(each));
    reference.condition.push_back(condition_number(each, each.values()));
  });
  return reference;
}

double ulps(double found, double right) {
  if (found == right) return 0;
  const double size = std::abs(right);
  return std::abs(found - right) / (std::nextafter(size, HUGE_VAL) - size);
}

EvaluatorError assess(const WayAnswers& answers, const Inputs& inputs,
                      const VelocityReference& reference) {
  EvaluatorError result;
  result.key = answers.way.key;
  result.name = answers.way.name;
  result.measured = true;
  result.nanoseconds = answers.nanoseconds;
  std::vector<double> errors;
  double squares = 0;
  std::size_t finite = 0;
  Failures failures;
  for (std::size_t i = 0; i < answers.values.size(); ++i) {
    const double found = answers.values[i], right = reference.right[i];
    errors.push_back(ulps(found, right));
    if (!std::isfinite(right)) continue;
    result.histogram.add(errors[i]);
    failures.add(found, right, reference.condition[i]);
    if (!std::isfinite(errors[i])) continue;
    result.worst = std::max(result.worst, errors[i]);
    squares += errors[i] * errors[i];
    ++finite;
  }
  if (finite > 0) result.rms = std::sqrt(squares / static_cast<double>(finite));
  result.worst_inputs = worst_inputs(answers, inputs, reference, errors);
  result.failure = failures.words();
  return result;
}

void mark_front(std::vector<EvaluatorError>& ways) {
  std::vector<EvaluatorError*> ranked;
  std::vector<CostAndError> points;
  for (EvaluatorError& way : ways)
    if (way.failure.empty()) {
      ranked.push_back(&way);
      points.push_back({way.nanoseconds, way.worst});
    }
  const std::vector<bool> front = on_front(points);
  for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i]->on_front = front[i];
}

EvaluatorErrors evaluator_errors(const Problem& problem, const Driver* driver,
                                 const Inputs& inputs) {
  EvaluatorErrors result;
  result.seed = inputs.seed;
  result.sets = inputs.sets.size();
  result.near_resonance = inputs.near_resonance;
  result.near_antiresonance = inputs.near_antiresonance;
  for (const Symbol& symbol : inputs.symbols) result.symbols.push_back(as_called(problem, symbol));
  const VelocityReference reference = reference_of(problem, inputs);
  if (driver != nullptr) {
    std::vector<std::string> keys;
    for (const Way& way : driver->ways()) keys.push_back(way.key);
    for (const WayAnswers& answers : driver->run(inputs.sets, keys))
      result.ways.push_back(assess(answers, inputs, reference));
  }
  result.ways.push_back(assess(library_answers(problem, inputs), inputs, reference));
  if (driver != nullptr)
    for (const Missing& missing : driver->missing()) {
      EvaluatorError& way = result.ways.emplace_back();
      way.key = missing.way.key;
      way.name = missing.way.name;
      way.failure = missing.reason;
    }
  mark_front(result.ways);
  return result;
}

}  // namespace vcrit::validation::accuracy
