#include "design/solve.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "base/speeds.hpp"
#include "critical/admissibility.hpp"
#include "design/explain.hpp"
#include "design/first_reach.hpp"
#include "design/opening.hpp"
#include "design/range.hpp"
#include "modes/general_modes.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "scene/range.hpp"

namespace vcrit::design {

namespace {

// A step for the slope at the answer: far above rounding, far below what bends the curve.
constexpr double part_for_slope = 1e-4;

class Solving {
 public:
  explicit Solving(const DesignQuestion& question)
      : question_(question), contact_(checked(question).problem), range_(range()) {}

  DesignAnswer run() {
    for (const std::vector<double>& row : range_.rows) {
      const ReachSearch search =
          first_reach([&](double value) { return ratio(value); }, row, question_.friction_ratio);
      count(search);
      if (search.reach && unanswered_ > 0) fail(search.reach->at);
      if (search.reach) return answer(*search.reach, row.front());
    }
    fail({});
  }

 private:
  [[noreturn]] void fail(std::optional<double> reached_at) const {
    throw ModelError(explanation({question_, contact_, range_, least_, least_at_, evaluations_,
                                  unanswered_, first_reason_, reached_at}));
  }

  static const DesignQuestion& checked(const DesignQuestion& question) {
    if (!(question.friction_ratio > 0 && question.friction_ratio < 1))
      throw InputError(argument("friction_ratio"), fmt::format("{}", question.friction_ratio),
                       "a ratio between 0 and 1, both excluded");
    if (question.sought != Sought::velocity) check_speed(question.velocity, argument("velocity"));
    for (const auto& [end, name] : {std::pair(question.from, "from"), {question.to, "to"}})
      if (end && !(*end > 0))
        throw InputError(argument(name), rounded(*end, unit_of(question.sought), all_digits),
                         "a number above 0");
    for (const auto& [end, name] : {std::pair(question.from, "from"), {question.to, "to"}})
      if (question.sought == Sought::frequency && end && !frequency_range.holds(*end))
        throw InputError(argument(name), rounded(*end, "Hz", all_digits), frequency_range.expected);
    const int samples = samples_of(question);
    if (samples < 3 || samples > most_samples)
      throw InputError(argument("samples"), fmt::format("{}", samples),
                       fmt::format("a number from 3 to {}", most_samples));
    problem_of(question, 1).values();  // what is sought needs no value
    if (question.sought != Sought::amplitude && question.problem->amplitude.value == 0)
      throw ModelError("without vibration, an amplitude of 0, friction is full at every speed",
                       "give an amplitude, or `for amplitude` to find one");
    return question;
  }

  // A drive that is not simulated is named before anything is searched.
  SearchRange range() const {
    if (question_.sought == Sought::velocity) {
      SteadyFriction{question_.problem};
    } else if (question_.sought == Sought::force) {
      const Problem there = with_load(question_.problem, 1);
      const double least = contact_.least_force(there.value(there->amplitude),
                                                there.value(there->angular_frequency));
      SteadyFriction{with_load(there, rules::cells_move(there) ? 2 * least : 1 + 2 * least)};
    } else {
      const double omega = question_.problem->angular_frequency.value.value_or(1);
      const Problem there = with_angular_frequency(question_.problem, omega);
      rules::require(rules::Question::closed_amplitude, with_amplitude(there, 0));
      SteadyFriction{with_amplitude(there, contact_.largest_amplitude(omega) / 2)};
    }
    return range_of(question_, contact_);
  }

  static std::size_t effort_of(const DesignQuestion& question) {
    return question.effort.value_or(rules::cells_move(question.problem)
                                        ? simulation::effort_of_cells
                                        : simulation::effort_of_answer);
  }

  /// With a value of what is sought, as it is searched for.
  static Problem problem_of(const DesignQuestion& question, double value) {
    switch (question.sought) {
      case Sought::amplitude:
        return with_amplitude(question.problem, value);
      case Sought::frequency:
        return with_angular_frequency(question.problem, two_pi * value);
      case Sought::force:
        return with_load(question.problem, value);
      case Sought::velocity:
        return question.problem;
    }
    throw Bug("something sought without a scene");
  }

  Problem problem_at(double value) const { return problem_of(question_, value); }

  double velocity_at(double value) const {
    return question_.sought == Sought::velocity ? value : question_.velocity;
  }

  simulation::SteadyState state_at(double value) const {
    return SteadyFriction(problem_at(value), &effort_, &known_modes_).at(velocity_at(value));
  }

  std::optional<double> ratio(double value) const {
    try {
      return state_at(value).friction_ratio;
    } catch (const ModelError& error) {
      if (first_reason_.empty()) first_reason_ = error.what();
      return std::nullopt;
    }
  }

  void count(const ReachSearch& search) {
    evaluations_ += search.evaluations;
    unanswered_ += search.unanswered;
    if (search.least && (!least_ || *search.least < *least_))
      least_ = search.least, least_at_ = search.least_at;
  }

  // The bracket's width, and what the error of the ratio moves the answer by.
  double error_of(const Reach& reach, const simulation::SteadyState& state) const {
    const double width = std::abs(reach.at - reach.before);
    const double step = part_for_slope * (reach.sample - reach.at);
    const std::optional<double> other = ratio(reach.at + step);
    const double rise = other ? *other - state.friction_ratio : 0;
    if (!(rise > 0)) return width + std::abs(step);
    return width + std::abs(step) * state.friction_ratio_error / rise;
  }

  int samples() const {
    if (!rules::cells_move(question_.problem)) return samples_of(question_);
    std::size_t all = 0;
    for (const std::vector<double>& row : range_.rows) all += row.size();
    return static_cast<int>(all);
  }

  DesignAnswer answer(const Reach& reach, double row_start) const {
    const Problem problem = problem_at(reach.at);
    DesignAnswer result;
    result.value = reach.at;
    result.velocity = velocity_at(reach.at);
    result.critical_velocity = critical_onset(problem).contact_velocity;
    result.state = state_at(reach.at);
    result.at_start = reach.at == row_start;
    if (!result.at_start) result.value_error = error_of(reach, result.state);
    const double omega = *problem->angular_frequency.value;
    const NormalContact contact =
        question_.sought == Sought::force ? NormalContact(problem) : contact_;
    result.largest_amplitude = contact.largest_amplitude(omega);
    if (!opens(problem) && rules::answer(rules::Question::closed_range, problem))
      if (const auto most = contact.largest_angular_frequency(*problem->amplitude.value))
        result.largest_frequency = *most / two_pi;
    result.from = range_.from;
    result.to = range_.to;
    result.samples = samples();
    result.monotonic = range_.monotonic;
    result.evaluations = evaluations_;
    result.unanswered = unanswered_;
    return result;
  }

  DesignQuestion question_;
  NormalContact contact_;
  SearchRange range_;
  std::optional<double> least_;
  double least_at_ = 0;
  int evaluations_ = 0, unanswered_ = 0;
  mutable std::string first_reason_;
  mutable simulation::SharedEffort effort_{effort_of(question_)};
  mutable simulation::KnownModes known_modes_;
};

}  // namespace

const char* to_text(Sought sought) {
  switch (sought) {
    case Sought::amplitude:
      return "amplitude";
    case Sought::frequency:
      return "frequency";
    case Sought::force:
      return "force";
    case Sought::velocity:
      return "velocity";
  }
  throw Bug("something sought without a name");
}

const char* unit_of(Sought sought) {
  switch (sought) {
    case Sought::amplitude:
      return "m";
    case Sought::frequency:
      return "Hz";
    case Sought::force:
      return "N";
    case Sought::velocity:
      return "m/s";
  }
  throw Bug("something sought without a unit");
}

Dimension dimension_of(Sought sought) {
  switch (sought) {
    case Sought::amplitude:
      return Dimension::length;
    case Sought::frequency:
      return Dimension::frequency;
    case Sought::force:
      return Dimension::force;
    case Sought::velocity:
      return Dimension::velocity;
  }
  throw Bug("something sought without a dimension");
}

int samples_of(const DesignQuestion& question) {
  return question.samples.value_or(
      rules::cells_move(question.problem) ? usual_samples_below_indenter : usual_samples);
}

bool is_largest(Sought sought) { return sought == Sought::force || sought == Sought::velocity; }

DesignAnswer solve(const DesignQuestion& question) { return Solving(question).run(); }

}  // namespace vcrit::design
