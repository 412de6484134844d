// Comparisons of the paper's numbers in few words.
#pragma once

#include <string>
#include <vector>

#include "compare/scene_report.hpp"

namespace vcrit::validation::paper {

/// Of friction, and of what it is compared with.
inline constexpr double friction_rounding = 0x1p-52;

/// What two numbers are and how far apart they may be; the numbers are still missing.
struct ComparedQuantity {
  std::string key, name, reference, reason;
  Comparison::Measure measure = Comparison::Measure::absolute;
};

/// One pair of numbers, and where it was found.
struct Pair {
  double expected = 0, found = 0, tolerance = 0;
  std::string detail;
};

Comparison comparison(const ComparedQuantity& what, const Pair& pair);

/// Of the pair nearest to its tolerance, or farthest beyond; broken where there are none.
Comparison worst(const ComparedQuantity& what, const std::vector<Pair>& pairs);

}  // namespace vcrit::validation::paper
