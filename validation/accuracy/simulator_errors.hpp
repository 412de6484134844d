// Steady states by every simulation method at several settings: error against run time.
#pragma once

#include "accuracy/data.hpp"
#include "accuracy/simulator_settings.hpp"
#include "problem/problem.hpp"

namespace vcrit::validation::accuracy {

/// What the others are compared with.
struct FrictionReference {
  double friction_ratio = 0;
  bool sticks = false;
  std::string words;
  std::optional<double> agreement;  ///< as in SpeedSolves
};

/// Fills in error and failure of an answered solve.
void judge(Solve& solve, const Setting& setting, bool sticks, const FrictionReference& reference);

/// By seconds and error; those that failed are left aside.
void mark_front(std::vector<Solve>& solves);

/// At speeds of `ratios` times the critical speed of the drive. Throws ModelError where the scene
/// cannot be simulated.
std::vector<SpeedSolves> simulator_errors(const Problem& problem,
                                          const std::vector<double>& ratios);

}  // namespace vcrit::validation::accuracy
