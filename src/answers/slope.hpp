// The slope of a function that is known to some digits, by differences, with an estimate of its
// error: where the function bends nearby the steps are short, and where it bends at the very place
// the slopes to both sides differ and the error says so.
#pragma once

#include <functional>
#include <optional>

namespace vcrit {

struct Slope {
  double value = 0;
  double error = 0;             ///< estimate; infinite where too few values are known
  double below = 0, above = 0;  ///< to either side
};

/// Of f at 0, for x that are logarithms: steps are 1e-3 or less, and up to 0.05 where the values
/// are known to an error of `noise` only. f has nothing where it is not known.
Slope slope_at_zero(const std::function<std::optional<double>(double)>& f, double noise);

}  // namespace vcrit
