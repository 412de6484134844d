// What the data say of the stiffness itself, whatever the number of branches: for K' and K'' the
// lowest and the highest value that any series of springs and dampers has which fits the data.
#pragma once

#include <vector>

#include "fit/fit.hpp"

namespace vcrit::fit {

struct KnownStiffness {
  double omega = 0;              ///< rad/s
  double storage = 0, loss = 0;  ///< of the fitted series, N/m; inside the intervals
  Interval storage_interval, loss_interval;
};

/// At each of these frequencies (rad/s).
std::vector<KnownStiffness> known_stiffness(const StiffnessTable& data, const Fit& fit,
                                            const std::vector<double>& omegas);

/// Frequencies (rad/s) from the first of the data to the last, evenly spaced in their logarithm.
std::vector<double> frequencies_across(const StiffnessTable& data);

}  // namespace vcrit::fit
