// The comparison as text for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "harness/text_table.hpp"
#include "speed/measurement.hpp"

namespace vcrit::speed {

struct SpeedComparison {
  std::string compiler;  ///< "g++ (Debian 12.2.0-14) 12.2.0"
  Plan plan;
  std::vector<std::string> subjects;
  std::vector<Result> results;
  std::vector<MissingMethod> missing;
};

using bench::TableStyle;

/// Machine, compiler and flags.
std::string heading(const SpeedComparison& all);
/// Methods by problems: nanoseconds a value, and the worst error in ulp; then the fastest of the
/// other methods, and how many times faster ours are.
std::string table(const SpeedComparison& all, CallMode mode, TableStyle style);
/// What is not in the tables, and why.
std::string notes(const SpeedComparison& all);

/// All figures, as JSON.
std::string as_json(const SpeedComparison& all);

}  // namespace vcrit::speed
