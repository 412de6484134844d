#include "answers/critical_onsets.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include "answers/critical_onset.hpp"
#include "critical/columns.hpp"
#include "modes/general_modes.hpp"
#include "problem/variation.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"

namespace vcrit {

namespace {

using Columns = std::span<const std::span<const double>>;

// Of the formula at once; what they hold is copied, as `out` may be a column.
constexpr std::size_t lanes_at_once = 256;

// Whether any is not above 0 and finite. Ordered as integers, such doubles lie between 0 and
// infinity, both left out: the difference to a border has the top bit where it is crossed. Without
// a branch the compiler takes several values at once, which halves the time.
bool any_unusual(std::span<const double> values) {
  constexpr auto infinite = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  std::uint64_t crossed = 0;
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    crossed |= (bits - 1) | (infinite - 1 - bits);
  }
  return crossed >> 63U != 0;
}

}  // namespace

/// The lanes of a call, each as its values and, when asked for, its problem.
class CriticalOnsets::Lanes {
 public:
  Lanes(const CriticalOnsets& onsets, Columns columns)
      : columns_(columns), changing_(onsets.problem_, onsets.names_), values_(columns.size()) {}

  void go_to(std::size_t lane) {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      values_[i] = columns_[i][columns_[i].size() == 1 ? 0 : lane];
  }

  bool is_unknown() const {
    return std::any_of(values_.begin(), values_.end(), [](double v) { return std::isnan(v); });
  }

  Problem problem() const { return changing_.at(values_); }

  /// v*, where that is not `formula`.
  double velocity(double formula) {
    if (is_unknown()) return std::numeric_limits<double>::quiet_NaN();
    if (values_ != answered_) velocity_ = simulated();
    answered_ = values_;
    return velocity_.value_or(formula);
  }

  /// Nothing if the scene may have these values. Only which of them are 0 changes its networks.
  std::optional<std::string> refused() {
    if (is_unknown()) return std::nullopt;
    std::vector<bool> zeros(values_.size());
    bool only_zeros = true;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      zeros[i] = values_[i] == 0;
      only_zeros = only_zeros && values_[i] >= 0 && std::isfinite(values_[i]);
    }
    if (only_zeros && allowed_.contains(zeros)) return std::nullopt;
    try {
      problem();
    } catch (const InputError& error) {
      return error.what();
    }
    if (only_zeros) allowed_.insert(zeros);
    return std::nullopt;
  }

 private:
  std::optional<double> simulated() {
    try {
      const Problem lane = problem();
      if (rules::answer(rules::Question::formula, lane)) return std::nullopt;
      return critical_onset(lane, &known_modes_).contact_velocity;
    } catch (const ModelError&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

  Columns columns_;
  Variation changing_;
  simulation::KnownModes known_modes_;
  std::vector<double> values_;
  std::optional<std::vector<double>> answered_;  // values of the lane answered last
  std::optional<double> velocity_;               // and its v*
  std::set<std::vector<bool>> allowed_;
};

CriticalOnsets::CriticalOnsets(const Problem& problem, std::vector<std::string> varying,
                               Grade grade)
    : problem_(problem), names_(varying), formula_(problem, std::move(varying), grade) {}

void CriticalOnsets::operator()(Columns columns, std::span<double> out) const {
  if (!rules::Facts(problem_).is(rules::SceneKind::separating) &&
      rules::answer(rules::Question::derivation, problem_))
    return formula_(columns, out);
  check_columns(names_, columns, out.size());
  Lanes lanes(*this, columns);
  std::vector<std::span<const double>> part(columns.begin(), columns.end());
  std::array<double, lanes_at_once> room{};
  for (std::size_t first = 0; first < out.size(); first += lanes_at_once) {
    const std::size_t count = std::min(lanes_at_once, out.size() - first);
    for (std::size_t i = 0; i < part.size(); ++i)
      if (columns[i].size() == out.size()) part[i] = columns[i].subspan(first, count);
    const std::span<double> velocities = std::span(room).first(count);
    formula_(part, velocities);
    for (std::size_t i = 0; i < count; ++i) {
      lanes.go_to(first + i);
      velocities[i] = lanes.velocity(velocities[i]);
    }
    std::copy(velocities.begin(), velocities.end(),
              out.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

std::optional<CriticalOnsets::Refused> CriticalOnsets::first_refused(Columns columns,
                                                                     std::size_t rows) const {
  check_columns(names_, columns, rows);
  if (std::none_of(columns.begin(), columns.end(), any_unusual)) return std::nullopt;
  Lanes lanes(*this, columns);
  for (std::size_t lane = 0; lane < rows; ++lane) {
    lanes.go_to(lane);
    if (auto why = lanes.refused()) return Refused{lane, std::move(*why)};
  }
  return std::nullopt;
}

}  // namespace vcrit
