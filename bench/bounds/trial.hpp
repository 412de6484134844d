// Many cases of a system, drawn, answered and judged on several threads; the same for the same
// seed, however many threads there are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bounds/draws.hpp"
#include "bounds/evaluator.hpp"
#include "bounds/systems.hpp"
#include "bounds/verdict.hpp"

namespace vcrit::bounds {

struct TrialOptions {
  std::uint64_t cases = 1'000'000;
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

/// Tallies by the kind of draw, which the cases take in turns.
using Tallies = std::map<Draw, TrialTally>;
TrialTally sum_of(const Tallies& tallies);

/// Calls task(0) to task(count - 1) on so many threads. The first exception is thrown again.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

Tallies try_cases(const TrialSystem& system, const CompiledHeader& evaluator,
                  const TrialOptions& options);

}  // namespace vcrit::bounds
