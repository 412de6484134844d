// The Prony series with as few branches as the noise of the data allows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/chances.hpp"
#include "scene/stiffness_data.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::fit {

struct Options {
  /// Whether a damper beside the branches is tried from the start; else only where springs and
  /// branches leave what is no noise.
  bool damper = false;
  int most_branches = 20;
};

/// A number above 0 and one standard deviation of it: that of its logarithm, times the number.
struct Uncertain {
  double value = 0, error = 0;
};

/// Of 95 %: from the lowest to the highest value.
struct Interval {
  double low = 0, high = 0;
};

/// That of the logarithm, in which the series is fitted. For small errors it is 1.96 of them each
/// way; by large ones that would reach below 0, and miss more of the truths above.
Interval interval_of(const Uncertain& number);

struct FittedBranch {
  Uncertain stiffness, time;  ///< N/m, s
};

/// One length that was tried: how much better it is than the one chosen before it, as the chance
/// that noise alone would make it so.
struct Trial {
  int branches = 0;
  double sum_of_squares = 0;  ///< of residuals in units of errors, as in `Weighed`
  std::optional<double> chance;
  double level = 0;  ///< below which it is taken
  bool taken = false;
};

struct Fit {
  Relaxation series;                             ///< by increasing time
  std::optional<Uncertain> equilibrium, damper;  ///< N/m, N s/m; none: not needed
  std::vector<FittedBranch> branches;
  double sum_of_squares = 0;
  int degrees_of_freedom = 0;
  double rms_relative = 0;       ///< root mean square of |fit - K|/|K|
  std::optional<double> noise;   ///< relative error of a component, estimated; none: it was given
  std::optional<double> chance;  ///< of a larger misfit by the errors given, none: not given
  /// One standard deviation of a residual, in its units, times Student's quantile over Gauss's.
  double error_unit = 0;
  std::vector<Trial> trials;
  /// Noise alone would seldom, but not hardly ever, make the series so long or keep it so short.
  bool order_in_doubt = false;
  bool exhausted = false;  ///< stopped at the most branches, the last of which still helped
  /// Of the only branch the data show no more than the end of its loss: its time is the last one
  /// that the search allows.
  bool time_at_an_end = false;
};

/// Throws InputError for data that no series fits or options out of range.
Fit fitted(const StiffnessTable& data, const Options& options = {});

/// Root mean square misfit above which no series comes near the data: measurements are better.
constexpr double far_off = 0.2;

}  // namespace vcrit::fit
