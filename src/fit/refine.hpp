// A Prony series of given length brought to its least squares: the logarithms of all stiffnesses,
// times and dampers by the Levenberg-Marquardt method of GSL.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/model.hpp"

namespace vcrit::fit {

struct Refined {
  Relaxation series;
  double sum_of_squares = 0;  ///< of the weighed residuals
  /// By the logarithms of k0, c (those that the terms have), all k_j, all tau_j.
  Eigen::MatrixXd slopes;
};

/// From a series whose terms are all above 0. Nothing where a relaxation time runs out of the range
/// that the data speak of, or the search does not settle.
std::optional<Refined> refined(const Weighed& data, const Terms& terms, const Relaxation& start);

/// A series with its slopes, not refined.
Refined as_it_is(const Weighed& data, const Terms& terms, const Relaxation& series);

/// The relaxation times that the data speak of: to a decade beyond the frequencies, s.
struct TimeRange {
  double from = 0, to = 0;
};
TimeRange time_range(const Weighed& data);

/// The stiffnesses, k0 and c >= 0 that fit best with these times (s).
Relaxation linear_fit(const Weighed& data, const Terms& terms, const std::vector<double>& times);

}  // namespace vcrit::fit
