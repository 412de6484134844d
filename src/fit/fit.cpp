#include "fit/fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "base/rounded.hpp"
#include "fit/starts.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::fit {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Noise below this relative size is taken for rounding of the data, and for its own.
constexpr double finest_noise = 1e-11;

// A length that brings nothing may hide one that does: two branches for one, say.
constexpr int look_ahead = 2;

// The least part of the softest data that a term begins with, so that its logarithm can move.
constexpr double first_part = 1e-3;

class Fitting {
 public:
  Fitting(const StiffnessTable& data, const Options& options,
          const std::optional<Relaxation>& expected = {})
      : given_(data), data_(data, expected), options_(options), terms_{true, options.damper} {}

  Fit run() {
    choose_length();
    if (chosen_.series.branches.empty()) take_a_branch_at_an_end();
    leave_out(&Terms::damper, false);
    leave_out(&Terms::equilibrium, true);
    return described();
  }

 private:
  int degrees(const Refined& fit) const {
    return static_cast<int>(data_.size() - fit.slopes.cols());
  }

  // Rounding is never taken for something to fit.
  double with_floor(double sum_of_squares) const {
    const double floor = data_.errors_known() ? 0 : finest_noise * finest_noise;
    return sum_of_squares + floor * static_cast<double>(data_.size());
  }

  double chance(const Refined& before, const Refined& after) const {
    return chance_of_fall(with_floor(before.sum_of_squares), with_floor(after.sum_of_squares),
                          static_cast<int>(after.slopes.cols() - before.slopes.cols()),
                          degrees(after), data_.errors_known());
  }

  Judgement judgement(const Refined& shorter, const Refined& longer) const {
    return judgement_of_fall(with_floor(shorter.sum_of_squares), with_floor(longer.sum_of_squares),
                             static_cast<int>(longer.slopes.cols() - shorter.slopes.cols()),
                             degrees(longer), data_.errors_known());
  }

  // Whether the longer series is to be taken. A lone spring takes all loss for noise: it stands
  // only where the losses may be 0.
  Judgement judgement(const Refined& longer) const {
    const Judgement found = judgement(chosen_, longer);
    if (found.clear() || !chosen_.series.branches.empty() || terms_.damper) return found;
    return {chance(chosen_, longer), shows_loss(given_) ? 1 : first_level};
  }

  // Terms that came out at 0 begin small instead.
  std::optional<Refined> improved(std::optional<Relaxation> start) const {
    if (!start) return std::nullopt;
    double softest = infinity;
    double thinnest = softest;
    for (const StiffnessRow& row : given_.rows) {
      softest = std::min(softest, std::hypot(row.storage, row.loss));
      thinnest = std::min(thinnest, std::hypot(row.storage, row.loss) / row.omega);
    }
    start->equilibrium = std::max(start->equilibrium, first_part * softest);
    start->damper = std::max(start->damper, first_part * thinnest);
    for (MaxwellBranch& branch : start->branches)
      branch.stiffness = std::max(branch.stiffness, first_part * softest);
    return refined(data_, terms_, *start);
  }

  std::optional<Refined> best(int branches, const std::optional<Refined>& shorter) const {
    std::optional<Refined> found = improved(merged(dense_, branches));
    if (shorter) {
      auto other = improved(with_another_branch(data_, terms_, *shorter));
      if (other && (!found || other->sum_of_squares < found->sum_of_squares))
        found = std::move(other);
    }
    return found;
  }

  void choose_length() {
    dense_ = dense_spectrum(data_, terms_);
    std::optional<Refined> last = refined(data_, terms_, at_least_terms());
    ensure(last.has_value(), "a spring can always be fitted");
    chosen_ = *last;
    trials_.push_back({0, last->sum_of_squares, std::nullopt, 0, false});
    int length = 0;
    for (int n = 1; n - length <= look_ahead && has_room_for(n); ++n) {
      hear_interruption();
      auto next = best(n, last);
      if (!next) {
        if (!last) break;
        last.reset();
        continue;
      }
      const Judgement judged = judgement(*next);
      trials_.push_back({n, next->sum_of_squares, judged.chance, judged.level, judged.clear()});
      last = next;
      if (!judged.clear()) continue;
      chosen_ = std::move(*next);
      length = n;
    }
    exhausted_ = length == options_.most_branches;
  }

  // Where the data see no more of a branch than the tail of its loss, its relaxation time runs out
  // of the range: the nearest time in it does the same.
  void take_a_branch_at_an_end() {
    if (!has_room_for(1)) return;
    const TimeRange range = time_range(data_);
    for (const double time : {range.from, range.to}) {
      const Relaxation series = linear_fit(data_, terms_, {time});
      if (!(series.branches.front().stiffness > 0) || !(series.equilibrium > 0)) continue;
      Refined fit = as_it_is(data_, terms_, series);
      const Judgement judged = judgement(fit);
      trials_.push_back({1, fit.sum_of_squares, judged.chance, judged.level, judged.clear()});
      if (!judged.clear()) continue;
      chosen_ = std::move(fit);
      at_an_end_ = true;
    }
  }

  Relaxation at_least_terms() const {
    Relaxation start = linear_fit(data_, terms_, {});
    const StiffnessRow& softest = given_.rows.front();
    start.equilibrium =
        std::max(start.equilibrium, first_part * std::hypot(softest.storage, softest.loss));
    start.damper = std::max(start.damper, first_part * start.equilibrium / data_.highest());
    return start;
  }

  bool has_room_for(int branches) const {
    const int parameters = 2 * branches + 1 + (terms_.damper ? 1 : 0);
    return branches <= options_.most_branches && parameters < data_.size();
  }

  // Where dropping it costs no more than chance. Without an equilibrium spring the contact would
  // carry no static load: it goes only where nothing speaks for it.
  void leave_out(bool Terms::*term, bool unless_nothing_speaks_for_it) {
    if (!(terms_.*term) || chosen_.series.branches.empty()) return;
    Terms fewer = terms_;
    fewer.*term = false;
    const auto without = refined(data_, fewer, chosen_.series);
    if (!without) return;
    const Judgement judged = judgement(*without, chosen_);
    const double level = unless_nothing_speaks_for_it ? largest_chance : judged.level;
    if (judged.chance < level) return;
    terms_ = fewer;
    chosen_ = *without;
  }

  // Of the longest series taken, or of those that were not.
  bool order_in_doubt() const {
    bool doubt = false;
    for (const Trial& trial : trials_) {
      if (!trial.chance) continue;
      doubt = trial.taken ? *trial.chance > significance : doubt || *trial.chance < largest_chance;
    }
    return doubt;
  }

  // Noise as estimated from the misfit, or the errors given. Where the misfit shows these to be too
  // small they are taken larger.
  double scale_of_errors() const {
    const int nu = degrees(chosen_);
    const double from_misfit = std::sqrt(chosen_.sum_of_squares / nu);
    if (!data_.errors_known()) return from_misfit * widening(nu);
    const bool explained = chance_of_misfit(chosen_.sum_of_squares, nu) >= significance;
    return explained ? 1 : std::max(1.0, from_misfit);
  }

  // One standard deviation of each logarithm, from the inverse of the normal matrix.
  VectorXd relative_errors() const {
    return scale_of_errors() * linear::Qr(chosen_.slopes).inverse_upper().rowwise().norm();
  }

  double rms_relative() const {
    double sum = 0;
    for (const StiffnessRow& row : given_.rows) {
      const std::complex<double> k(row.storage, row.loss);
      sum += std::norm((dynamic_stiffness(chosen_.series, row.omega) - k) / k);
    }
    return std::sqrt(sum / static_cast<double>(given_.rows.size()));
  }

  Fit described() {
    Fit fit;
    const VectorXd errors = relative_errors();
    const auto with_error = [&](double value, Index i) {
      return Uncertain{value, value * errors[i]};
    };
    const auto& branches = chosen_.series.branches;
    Index i = 0;
    if (terms_.equilibrium) fit.equilibrium = with_error(chosen_.series.equilibrium, i++);
    if (terms_.damper) fit.damper = with_error(chosen_.series.damper, i++);
    const auto count = static_cast<Index>(branches.size());
    for (const MaxwellBranch& branch : branches) {
      fit.branches.push_back({with_error(branch.stiffness, i), with_error(branch.time, count + i)});
      ++i;
    }
    std::sort(fit.branches.begin(), fit.branches.end(),
              [](const auto& a, const auto& b) { return a.time.value < b.time.value; });
    fit.series = chosen_.series;
    std::sort(fit.series.branches.begin(), fit.series.branches.end(),
              [](const auto& a, const auto& b) { return a.time < b.time; });
    fit.sum_of_squares = chosen_.sum_of_squares;
    fit.degrees_of_freedom = degrees(chosen_);
    fit.rms_relative = rms_relative();
    fit.error_unit = scale_of_errors();
    if (data_.errors_known())
      fit.chance = chance_of_misfit(fit.sum_of_squares, fit.degrees_of_freedom);
    else
      fit.noise = std::sqrt(fit.sum_of_squares / fit.degrees_of_freedom);
    fit.trials = trials_;
    fit.order_in_doubt = order_in_doubt();
    fit.exhausted = exhausted_;
    fit.time_at_an_end = at_an_end_;
    return fit;
  }

  const StiffnessTable& given_;
  Weighed data_;
  Options options_;
  Terms terms_;
  Relaxation dense_;
  Refined chosen_;
  std::vector<Trial> trials_;
  bool exhausted_ = false, at_an_end_ = false;
};

// Whether i has the other sign in these data: losses that are too low for noise, or all of which
// are, and by half of what is usual on average.
bool has_losses_of_wrong_sign(const StiffnessTable& data) {
  if (chance_of_mean(data, -1) < significance) return true;
  double sum = 0;
  for (const StiffnessRow& row : data.rows) {
    if (row.loss >= 0) return false;
    sum += row.loss / std::hypot(row.storage, row.loss);
  }
  return sum < -usual_noise / 2 * static_cast<double>(data.rows.size());
}

// Squares of their quotients are doubles, too.
constexpr double least_number = 1e-50, largest_number = 1e50;

void refuse_number(const StiffnessTable& data, const char* name, double value, const char* unit) {
  if (value >= least_number && value <= largest_number) return;
  throw InputError(
      {data.file}, fmt::format("{} of {}", name, rounded(value, unit)),
      fmt::format("{} to {}", rounded(least_number, unit), rounded(largest_number, unit)));
}

void refuse_extremes(const StiffnessTable& data) {
  for (const StiffnessRow& row : data.rows) {
    refuse_number(data, "an angular frequency", row.omega, "rad/s");
    refuse_number(data, "a stiffness", std::hypot(row.storage, row.loss), "N/m");
    if (!data.has_errors) continue;
    refuse_number(data, "an error", row.storage_error, "N/m");
    refuse_number(data, "an error", row.loss_error, "N/m");
  }
}

// A minute or two of one core, and half a gigabyte.
constexpr std::size_t most_rows = 100'000;

void refuse_what_cannot_be_fitted(const StiffnessTable& data) {
  if (data.rows.size() > most_rows)
    throw InputError({data.file}, fmt::format("{} rows of numbers", data.rows.size()),
                     fmt::format("at most {}", most_rows),
                     "put the mean of neighbouring rows in their place");
  refuse_extremes(data);
  if (data.rows.size() < least_rows)
    throw InputError({data.file}, fmt::format("{} rows of numbers", data.rows.size()),
                     fmt::format("at least {}", least_rows));
  if (has_losses_of_wrong_sign(data))
    throw InputError({data.file}, "losses that are below 0 on average",
                     "losses of at least 0: the imaginary part of K where the motion is "
                     "exp(+i omega t)");
}

// No measurement of a phase resolves less, as a part of |K|.
constexpr double finest_phase = 1e-3;

// With fewer degrees of freedom than these a wrong row passes for noise of all of them, and noise
// is believed up to this part of |K|: four times that is a tenth.
constexpr int degrees_that_tell = 10;
constexpr double noise_of_few = 0.025;

// The noise of all data but this row, which would hide behind its own misfit.
double noise_beside(const StiffnessRow& row, const Fit& fit) {
  const std::complex<double> k = dynamic_stiffness(fit.series, row.omega);
  const double own = std::norm((std::complex<double>(row.storage, row.loss) - k) / std::abs(k));
  const int degrees = fit.degrees_of_freedom;
  const double others = std::max(0.0, fit.sum_of_squares - own);
  const double noise = degrees > 2 ? std::sqrt(others / (degrees - 2)) : *fit.noise;
  const double widest = noise * widening(std::max(1, degrees - 2));
  const double believed = degrees < degrees_that_tell ? std::min(widest, noise_of_few) : widest;
  return std::max(finest_phase, believed);
}

// What is negative by more than the noise that the fit has found.
void refuse_below_noise(const StiffnessTable& data, const Fit& fit) {
  if (data.has_errors) return;
  for (const StiffnessRow& row : data.rows) {
    const double noise = noise_beside(row, fit);
    const auto refuse = [&](const char* name, double value) {
      if (value < -errors_below_zero * noise * std::hypot(row.storage, row.loss))
        throw InputError({data.file, row.line}, fmt::format("{} = {}", name, rounded(value, "N/m")),
                         fmt::format("a {} stiffness of at least 0, or below it by no more than "
                                     "four times the noise of these data, {:.2g} % of |K|",
                                     name, 100 * noise));
    };
    refuse("storage", row.storage);
    refuse("loss", row.loss);
  }
}

// Springs and branches leave what is no noise, or the tail of a loss that a damper may have as
// well.
bool wants_a_damper(const Fit& fit) {
  if (fit.chance) return *fit.chance < significance;
  return fit.time_at_an_end || *fit.noise > usual_noise;
}

double per_degree(const Fit& fit) { return fit.sum_of_squares / fit.degrees_of_freedom; }

}  // namespace

Interval interval_of(const Uncertain& number) {
  const double factor = std::exp(reach * number.error / number.value);
  return {number.value / factor, number.value * factor};
}

Fit fitted(const StiffnessTable& data, const Options& options) {
  if (options.most_branches < 1)
    throw InputError(argument("max_branches"), fmt::format("{}", options.most_branches),
                     "at least 1");
  refuse_what_cannot_be_fitted(data);
  Options chosen = options;
  Fit fit = Fitting(data, chosen).run();
  if (!options.damper && wants_a_damper(fit)) {
    chosen.damper = true;
    Fit damped = Fitting(data, chosen).run();
    const bool any_fall = fit.time_at_an_end || fit.rms_relative > far_off;
    const double fall = any_fall ? 1 : clear_fall;
    if (per_degree(damped) * fall * fall < per_degree(fit))
      fit = std::move(damped);
    else
      chosen = options;
  }
  const bool second = !data.has_errors && fit.rms_relative < far_off;
  if (second) fit = Fitting(data, chosen, fit.series).run();
  refuse_below_noise(data, fit);
  return fit;
}

}  // namespace vcrit::fit
