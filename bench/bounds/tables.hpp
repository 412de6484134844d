// The result of all trials as tables and as JSON.
#pragma once

#include <string>
#include <vector>

#include "bounds/trial.hpp"
#include "harness/text_table.hpp"

namespace vcrit::bounds {

struct SystemResult {
  std::string system;
  Tallies tallies;
};

/// One line a system, then one a kind of draw.
std::string tables(const std::vector<SystemResult>& results, bench::TableStyle style);

/// All counts, as JSON.
std::string as_json(const std::vector<SystemResult>& results, const TrialOptions& options);

/// The first violation of each kind by each system, in words; empty for none.
std::string first_violations(const std::vector<SystemResult>& results);

}  // namespace vcrit::bounds
