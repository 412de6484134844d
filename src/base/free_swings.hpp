// Of an oscillation cos t and free swings at some of its harmonics n > 1, whose amplitudes and
// phases may be anything: how low its maximum can be made,
//
//   E = min max over t of cos t + sum_n (a_n cos n t + b_n sin n t).
//
// With cos t the swing of a contact's velocity in sliding, in units of v*, sliding is steady from
// E v* on, and at no lower speed.
//
// A swing at a frequency that is no whole multiple does not help: over the periods until it is back
// at its phase, instants of the same t have no mean of it.
#pragma once

#include <optional>
#include <vector>

namespace vcrit {

/// lower <= E <= upper, both proved but for rounding; upper is attained.
struct LeastMaximum {
  double lower = 1, upper = 1;
  std::vector<double> swings =
      {};  ///< a_n that attain it, with no b_n, in the order of the harmonics
};

/// harmonics: different ones, each > 1. 1 for none, cos(pi/(2 n)) for one, the enclosure of a
/// linear program for more, some 1e-12 wide. Nothing for more than nine, and where the program does
/// not enclose E to 1e-9.
std::optional<LeastMaximum> least_maximum(const std::vector<int>& harmonics);

}  // namespace vcrit
