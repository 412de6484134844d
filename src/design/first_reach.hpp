// Where a function of one variable first comes down to a wanted value along a row of places: by
// samples, by a search of each dip between them, then by a bracketing root finder.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace vcrit::design {

/// A value, or nothing where there is no answer.
using Measured = std::function<std::optional<double>(double)>;

struct Reach {
  double at = 0;      ///< here the value is at most the wanted one,
  double before = 0;  ///< here, next to it, not yet; equal to `at` at the first place of all
  double sample = 0;  ///< the last place before both
};

struct ReachSearch {
  std::optional<Reach> reach;
  std::optional<double> least;  ///< the least value met; nothing without any answer
  double least_at = 0;
  int evaluations = 0;
  int unanswered = 0;  ///< of them; taken for places that do not reach
};

/// `places` in the order of the search, rising or falling. What is lower than `wanted` only between
/// two neighbours without showing as a dip of the samples is missed.
ReachSearch first_reach(const Measured& measured, const std::vector<double>& places, double wanted);

}  // namespace vcrit::design
