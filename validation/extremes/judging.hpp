// Answers of an evaluator against v* correctly rounded: what it loses, and whether what it claims
// is true.
#pragma once

#include <string>
#include <vector>

#include "extremes/contents.hpp"

namespace vcrit::validation::extremes {

/// What is known of each cell.
struct Known {
  std::vector<double> right;        ///< v* correctly rounded, m/s; NaN: 0/0
  std::vector<double> condition;    ///< number of Eq. 24
  std::vector<std::string> inputs;  ///< as in BadAnswer
};

/// Answers of one way; without bounds it claims nothing.
struct Claimed {
  std::string way;
  std::vector<double> values;  ///< m/s
  std::vector<double> bounds;  ///< relative; infinite: nothing is claimed there
};

/// |found - right| over what the bound allows: the bound itself, relative to v*, and the rounding
/// of `right`. Infinite where only one of the two is a finite number, or where v* is 0/0.
double over_bound(double found, double right, double bound);

/// Digits are lost where the error is above 32 roundings of 2^-53 times the condition number.
Tally tally(const Claimed& claimed, const Known& known);

/// Leaves a few, those that lost most digits first.
void keep_worst(std::vector<BadAnswer>& answers);

/// Whether every claimed bound held.
Comparison bounds_hold(const Tally& tally, const std::string& where);

}  // namespace vcrit::validation::extremes
