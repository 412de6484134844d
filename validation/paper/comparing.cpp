#include "paper/comparing.hpp"

namespace vcrit::validation::paper {

Comparison comparison(const ComparedQuantity& what, const Pair& pair) {
  Comparison result;
  result.key = what.key;
  result.name = what.name;
  result.reference = what.reference;
  result.reason = what.reason;
  result.measure = what.measure;
  result.expected = pair.expected;
  result.found = pair.found;
  result.tolerance = pair.tolerance;
  result.detail = pair.detail;
  return result;
}

Comparison worst(const ComparedQuantity& what, const std::vector<Pair>& pairs) {
  std::vector<Comparison> all;
  for (const Pair& pair : pairs) all.push_back(comparison(what, pair));
  if (const Comparison* found = tightest(all)) return *found;
  Comparison nothing = comparison(what, {0, 0, 0, "nothing was compared"});
  nothing.broken = true;
  return nothing;
}

}  // namespace vcrit::validation::paper
