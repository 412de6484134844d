#include "fit/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/nnls.hpp"
#include "fit/refine.hpp"
#include "fit/starts.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::fit {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Both ends and seven between: dense enough for a table, and for a curve through a few decades.
constexpr int frequencies = 9;

// Pivots below this part of the largest are rounding.
constexpr double rank_cut = 1e-13;

// Exact data: rounding in the search for an end of the interval stays below this part of |K|.
constexpr double finest_reach = 1e-9;

// The end of an interval is sought to this part of its width.
constexpr double precision = 0.01;
constexpr int most_steps = 24;
// Until a value outside is found.
constexpr double widening_step = 3;

// How much more the constraint weighs than the data: it is missed by the square of its inverse. A
// value that falls short of the wanted one by a larger part is near the limit of what any series
// has, and is pulled harder.
constexpr double least_pull = 20, harder = 10, falls_short = 0.1;

// Times of the series and, a standard deviation or two aside, their neighbours: mixtures of them
// have any time between.
constexpr double aside = 1.5, farthest_aside = 0.2;

std::vector<double> times_of_any_series(const Weighed& data, const Fit& fit) {
  std::vector<double> times = grid_of_times(data);
  for (const FittedBranch& branch : fit.branches) {
    const double relative = branch.time.error / branch.time.value;
    const double step = std::exp(std::min(aside * relative, farthest_aside));
    for (const double time :
         {branch.time.value / step, branch.time.value, branch.time.value * step})
      times.push_back(time);
  }
  return times;
}

// All series there are: a spring, a damper, and branches of any time, each with a stiffness >= 0.
class AnySeries {
 public:
  AnySeries(const Weighed& data, const Fit& fit) : times_(times_of_any_series(data, fit)) {
    MatrixXd columns(data.size(), static_cast<Index>(times_.size()) + 2);
    columns.col(0) = data.spring();
    columns.col(1) = data.damper();
    for (std::size_t j = 0; j < times_.size(); ++j)
      columns.col(static_cast<Index>(j) + 2) = data.branch(times_[j]);
    // Scaled to one length; and in the few directions that differ at all.
    size_ = columns.colwise().norm();
    columns = columns * size_.cwiseInverse().asDiagonal();
    const MatrixXd across = linear::PivotedQr(columns).range(rank_cut).transpose();
    matrix_ = across * columns;
    target_ = across * data.target();
    nearest_ = nonnegative_least_squares(matrix_, target_);
    least_ = misfit(nearest_);
    // The best of all series has fitted some of the noise, more than the one that was chosen: that
    // one is the measure.
    const double chosen = (across * data.residual(fit.series)).squaredNorm();
    const double grows = std::max(reach * fit.error_unit, finest_reach * target_.norm());
    allowed_ = std::max(0.0, chosen - least_) + grows * grows;
  }

  Interval interval(double omega, bool storage, double guess) const {
    const VectorXd values = row(omega, storage);
    return {end(values, -guess), end(values, guess)};
  }

 private:
  double misfit(const VectorXd& x) const { return (matrix_ * x - target_).squaredNorm(); }

  VectorXd row(double omega, bool storage) const {
    const auto part = [&](std::complex<double> k) { return storage ? k.real() : k.imag(); };
    VectorXd values(matrix_.cols());
    values[0] = part(1);
    values[1] = part({0, omega});
    for (std::size_t j = 0; j < times_.size(); ++j) {
      const std::complex<double> x(0, omega * times_[j]);
      values[static_cast<Index>(j) + 2] = part(x / (1.0 + x));
    }
    return values.cwiseQuotient(size_);
  }

  // The series that comes nearest to the data of those whose value is `wanted`, nearly.
  VectorXd with_value(const VectorXd& values, double wanted, double step, double pull) const {
    MatrixXd matrix(matrix_.rows() + 1, matrix_.cols());
    VectorXd target(target_.size() + 1);
    const double weight = pull * std::sqrt(allowed_) / std::abs(step);
    matrix << matrix_, weight * values.transpose();
    target << target_, weight * wanted;
    return nonnegative_least_squares(matrix, target);
  }

  // Where the misfit has grown by what is allowed: between a value inside and one outside, by
  // halves and, in turn, as if it grew like the square of the distance. It does where nothing is
  // at 0, and else faster. No value is below 0.
  double end(const VectorXd& values, double step) const {
    const double middle = values.dot(nearest_);
    Reached inside{middle, 0};
    std::optional<Reached> outside;
    double pull = least_pull;
    for (int i = 0; i < most_steps; ++i) {
      const double wanted = std::max(0.0, outside ? between(inside, *outside, i) : middle + step);
      if (wanted == middle) return middle;  // both 0: no loss at all
      const VectorXd x = with_value(values, wanted, wanted - middle, pull);
      const double grown = std::max(0.0, misfit(x) - least_) / allowed_;
      const Reached reached{values.dot(x), std::sqrt(grown)};
      if (reached.distance > 1)
        outside = reached;
      else if (wanted == 0)
        return 0;
      else if (std::abs(reached.value - middle) > std::abs(inside.value - middle))
        inside = reached;
      if (std::abs(wanted - reached.value) > falls_short * std::abs(wanted - middle))
        pull *= harder;
      else
        step *= widening_step;
      if (outside &&
          std::abs(outside->value - inside.value) < precision * std::abs(outside->value - middle))
        break;
    }
    return outside ? outside->value : inside.value;
  }

  // The distance is the root of how far the misfit has grown, as a part of what is allowed.
  struct Reached {
    double value = 0, distance = 0;
  };

  static double between(const Reached& inside, const Reached& outside, int step) {
    const double part =
        step % 2 == 0 ? 0.5 : (1 - inside.distance) / (outside.distance - inside.distance);
    return inside.value + part * (outside.value - inside.value);
  }

  std::vector<double> times_;
  VectorXd size_;
  MatrixXd matrix_;
  VectorXd target_, nearest_;
  double least_ = 0;    ///< misfit of the nearest
  double allowed_ = 0;  ///< by which it may grow
};

// Half of the last digit written, in the coarser of the two rows about this frequency. Rounding
// moves all rows of a plateau alike, so that no scatter shows it.
double half_a_digit(const StiffnessTable& data, double omega, double StiffnessRow::*step) {
  const auto above =
      std::lower_bound(data.rows.begin(), data.rows.end() - 1, omega,
                       [](const StiffnessRow& row, double at) { return row.omega < at; });
  const auto below = above == data.rows.begin() ? above : above - 1;
  return std::max((*above).*step, (*below).*step) / 2;
}

Interval widened(const Interval& interval, double fitted, double rounding) {
  return {std::max(0.0, std::min(interval.low, fitted) - rounding),
          std::max(interval.high, fitted) + rounding};
}

}  // namespace

std::vector<KnownStiffness> known_stiffness(const StiffnessTable& data, const Fit& fit,
                                            const std::vector<double>& omegas) {
  const bool near = fit.rms_relative < far_off;
  const Weighed weighed(data, near ? std::optional(fit.series) : std::nullopt);
  const AnySeries any(weighed, fit);
  std::vector<KnownStiffness> known;
  for (const double omega : omegas) {
    const std::complex<double> k = dynamic_stiffness(fit.series, omega);
    const double guess = data.has_errors
                             ? 0.02 * std::abs(k)
                             : std::max(finest_reach, reach * fit.error_unit) * std::abs(k);
    known.push_back({omega, k.real(), k.imag(),
                     widened(any.interval(omega, true, guess), k.real(),
                             half_a_digit(data, omega, &StiffnessRow::storage_step)),
                     widened(any.interval(omega, false, guess), k.imag(),
                             half_a_digit(data, omega, &StiffnessRow::loss_step))});
  }
  return known;
}

std::vector<double> frequencies_across(const StiffnessTable& data) {
  const double from = data.rows.front().omega, to = data.rows.back().omega;
  std::vector<double> omegas;
  for (int i = 0; i < frequencies; ++i)
    omegas.push_back(from * std::pow(to / from, static_cast<double>(i) / (frequencies - 1)));
  return omegas;
}

}  // namespace vcrit::fit
