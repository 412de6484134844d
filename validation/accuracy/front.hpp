// The Pareto front of cost against error.
#pragma once

#include <vector>

namespace vcrit::validation::accuracy {

struct CostAndError {
  double cost = 0, error = 0;
};

/// For each point, whether none is better in one and at least as good in the other.
std::vector<bool> on_front(const std::vector<CostAndError>& points);

}  // namespace vcrit::validation::accuracy
