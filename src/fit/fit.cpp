#include "fit/fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "fit/starts.hpp"

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
  Fitting(const Data& data, const Options& options, const std::optional<Relaxation>& expected = {})
      : given_(data), data_(data, expected), options_(options), terms_{true, options.damper} {}

  Fit run() {
    choose_length();
    leave_out(&Terms::damper);
    leave_out(&Terms::equilibrium);
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

  // Terms that came out at 0 begin small instead.
  std::optional<Refined> improved(std::optional<Relaxation> start) const {
    if (!start) return std::nullopt;
    double softest = infinity;
    double thinnest = softest;
    for (const Row& row : given_.rows) {
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
    trials_.push_back({0, last->sum_of_squares, std::nullopt});
    int length = 0;
    for (int n = 1; n - length <= look_ahead && has_room_for(n); ++n) {
      auto next = best(n, last);
      if (!next) {
        if (!last) break;
        last.reset();
        continue;
      }
      trials_.push_back({n, next->sum_of_squares, chance(chosen_, *next)});
      last = next;
      if (!(trials_.back().chance < significance)) continue;
      chosen_ = std::move(*next);
      length = n;
    }
    exhausted_ = length == options_.most_branches;
  }

  Relaxation at_least_terms() const {
    Relaxation start = linear_fit(data_, terms_, {});
    const Row& softest = given_.rows.front();
    start.equilibrium =
        std::max(start.equilibrium, first_part * std::hypot(softest.storage, softest.loss));
    start.damper = std::max(start.damper, first_part * start.equilibrium / data_.highest());
    return start;
  }

  bool has_room_for(int branches) const {
    const int parameters = 2 * branches + 1 + (terms_.damper ? 1 : 0);
    return branches <= options_.most_branches && parameters < data_.size();
  }

  void leave_out(bool Terms::*term) {
    if (!(terms_.*term) || chosen_.series.branches.empty()) return;
    Terms fewer = terms_;
    fewer.*term = false;
    const auto without = refined(data_, fewer, chosen_.series);
    if (!without || chance(*without, chosen_) < significance) return;
    terms_ = fewer;
    chosen_ = *without;
  }

  // One standard deviation of each logarithm, from the inverse of the normal matrix.
  VectorXd relative_errors() const {
    const Index p = chosen_.slopes.cols();
    const MatrixXd r = MatrixXd(chosen_.slopes.householderQr().matrixQR())
                           .topRows(p)
                           .triangularView<Eigen::Upper>();
    const MatrixXd inverse = r.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(p, p));
    const double scale =
        data_.errors_known() ? 1 : std::sqrt(chosen_.sum_of_squares / degrees(chosen_));
    return scale * inverse.rowwise().norm();
  }

  double rms_relative() const {
    double sum = 0;
    for (const Row& row : given_.rows) {
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
    if (data_.errors_known())
      fit.chance = boost::math::gamma_q(fit.degrees_of_freedom / 2.0, fit.sum_of_squares / 2);
    else
      fit.noise = std::sqrt(fit.sum_of_squares / fit.degrees_of_freedom);
    fit.trials = trials_;
    fit.exhausted = exhausted_;
    return fit;
  }

  const Data& given_;
  Weighed data_;
  Options options_;
  Terms terms_;
  Relaxation dense_;
  Refined chosen_;
  std::vector<Trial> trials_;
  bool exhausted_ = false;
};

}  // namespace

double chance_of_fall(double before, double after, int more, int degrees, bool errors_known) {
  if (!(after < before)) return 1;
  if (errors_known) return boost::math::gamma_q(more / 2.0, (before - after) / 2);
  return boost::math::ibeta(degrees / 2.0, more / 2.0, after / before);
}

Fit fitted(const Data& data, const Options& options) {
  if (options.most_branches < 1)
    throw InputError({"--max-branches"}, fmt::format("{}", options.most_branches), "at least 1");
  const Fit fit = Fitting(data, options).run();
  return data.has_errors ? fit : Fitting(data, options, fit.series).run();
}

}  // namespace vcrit::fit
