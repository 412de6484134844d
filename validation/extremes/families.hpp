// The scenes that are taken to extremes. Their numbers are near 1 in SI units, most of them powers
// of two or their multiples: no device, but a middle from which all extremes are equally far, and
// with resonances at exact doubles.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::validation::extremes {

/// A limit of a family: one number driven to it, and the scene that remains.
struct Approach {
  enum class To { zero, infinity };
  Symbol what;
  To to = To::zero;
  std::string text;  ///< the remaining scene
};

struct Family {
  std::string key, title;
  std::string text;  ///< a scene file
  std::vector<Approach> approaches;
};

const std::vector<Family>& families();

/// The scene of a family.
Problem problem_of(const Family& family);

}  // namespace vcrit::validation::extremes
