// The Prony series with as few branches as the noise of the data allows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/data.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::fit {

struct Options {
  bool damper = false;  ///< whether a damper beside the branches is tried
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
};

/// Throws InputError for data that no series fits or options out of range.
Fit fitted(const Data& data, const Options& options = {});

/// The chance below which a better fit is not put down to noise.
constexpr double significance = 1e-4;

/// The chance that `more` further parameters lower a sum of squares from `before` to `after` by
/// noise alone; `degrees`: of freedom after. With known errors the fall is chi-squared distributed,
/// else its ratio to the rest is F distributed.
double chance_of_fall(double before, double after, int more, int degrees, bool errors_known);

}  // namespace vcrit::fit
