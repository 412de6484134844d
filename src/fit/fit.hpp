// The Prony series with as few branches as the noise of the data allows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/data.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::fit {

struct Options {
  /// Whether a damper beside the branches is tried from the start; else only where springs and
  /// branches leave what is no noise.
  bool damper = false;
  int most_branches = 20;
};

/// A number and one standard deviation of it.
struct Uncertain {
  double value = 0, error = 0;
};

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
  std::vector<Trial> trials;
  bool exhausted = false;  ///< stopped at the most branches, the last of which still helped
  /// Of the only branch the data show no more than the end of its loss: its time is the last one
  /// that the search allows.
  bool time_at_an_end = false;
};

/// Throws InputError for data that no series fits or options out of range.
Fit fitted(const Data& data, const Options& options = {});

/// The chance below which a better fit is not put down to noise, where there are data enough.
constexpr double significance = 1e-4;
/// How far the misfit must fall, and the chance that this is noise, where there are few.
constexpr double clear_fall = 3, largest_chance = 0.05;
/// The chance below which a longer series is taken that leaves so many degrees of freedom. As the
/// noise is estimated from what is left, a misfit that falls by a factor q (with two parameters
/// more) has a chance of q^-degrees: from 9 degrees on 3 is more than enough, and for fewer rows
/// `significance` would be out of reach.
double level(int degrees);

/// Whether the losses, as parts of |K|, are above 0 on average by more than their scatter explains:
/// Student's test, by one side (Gauss's where errors are given).
bool shows_loss(const Data& data);

/// The same chance for the first branch: one too many is told as poorly known, one too few loses all
/// loss.
constexpr double first_level = 0.01;
/// And where few rows leave more than `usual_noise` (of |K|, root mean square) to a lone spring:
/// stiffness is measured better than that.
constexpr double doubtful_level = 0.3, usual_noise = 0.02;
/// For any series that would have to put so much (of |K|) down to noise: the larger it is beyond the
/// usual, the less is it to be believed.
double level_at(double noise);

/// One standard deviation is estimated from few degrees of freedom: what it must be multiplied by so
/// that 1.96 of it hold the truth in 95 of 100 cases, Student's quantile over Gauss's.
double widening(int degrees);

/// Root mean square misfit above which no series comes near the data: measurements are better.
constexpr double far_off = 0.2;

/// The chance that `more` further parameters lower a sum of squares from `before` to `after` by
/// noise alone; `degrees`: of freedom after. With known errors the fall is chi-squared distributed,
/// else its ratio to the rest is F distributed.
double chance_of_fall(double before, double after, int more, int degrees, bool errors_known);

}  // namespace vcrit::fit
