#include "extremes/comparing.hpp"

namespace vcrit::validation::extremes {

namespace {

Comparison named(const Words& words) {
  Comparison result;
  result.key = words.key;
  result.name = words.name;
  result.reference = words.reference;
  result.reason = words.reason;
  return result;
}

}  // namespace

Comparison at_most(const Words& words, double found, double most, const std::string& detail) {
  Comparison result = named(words);
  result.measure = Comparison::Measure::absolute;
  result.found = found;
  result.tolerance = most;
  result.detail = detail;
  return result;
}

Comparison relative(const Words& words, double expected, double found, double tolerance,
                    const std::string& detail) {
  Comparison result = named(words);
  result.unit = "m/s";
  result.expected = expected;
  result.found = found;
  result.tolerance = tolerance;
  result.detail = detail;
  return result;
}

Comparison worst(const Words& words, const std::vector<Comparison>& all) {
  if (const Comparison* found = tightest(all)) return *found;
  Comparison nothing = named(words);
  nothing.broken = true;
  nothing.detail = "nothing was compared";
  return nothing;
}

Comparison not_compared(const Words& words, const std::string& why) {
  Comparison result = named(words);
  result.not_run = true;
  result.detail = why;
  return result;
}

}  // namespace vcrit::validation::extremes
