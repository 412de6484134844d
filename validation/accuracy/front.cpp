#include "accuracy/front.hpp"

#include <algorithm>

namespace vcrit::validation::accuracy {

std::vector<bool> on_front(const std::vector<CostAndError>& points) {
  const auto beats = [](const CostAndError& a, const CostAndError& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
  };
  std::vector<bool> result;
  for (const CostAndError& own : points)
    result.push_back(std::none_of(points.begin(), points.end(),
                                  [&](const CostAndError& other) { return beats(other, own); }));
  return result;
}

}  // namespace vcrit::validation::accuracy
