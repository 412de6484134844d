// How `vcrit validate` ended: the verdicts, and what was written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "compare/scene_report.hpp"

namespace vcrit::validation::report {

/// How one comparison ended.
struct ComparisonVerdict {
  std::string subject;    ///< the scene's file, "the paper" or "extremes"
  std::string key, name;  ///< of the comparison
  std::string outcome;    ///< "passed", "failed" or "not run"
};

struct Validation {
  std::vector<ComparisonVerdict> verdicts;   ///< of all comparisons
  bool passed = true;                        ///< no comparison failed
  std::vector<std::string> failed;           ///< "scenes/zener.toml: stick-slip simulation"
  std::vector<std::string> not_run;          ///< the same for comparisons that could not be made
  std::vector<std::string> warnings;         ///< of reading the scenes
  std::filesystem::path page;                ///< DIR/index.html
  std::vector<std::filesystem::path> files;  ///< all that were written, the page last

  void add(const ComparisonVerdict& verdict);
  void add(const std::string& subject, const std::vector<Comparison>& comparisons);
  /// Writes all of them or none. Throws InputError naming the file that cannot be written.
  void write(const std::vector<NewFile>& all);
};

}  // namespace vcrit::validation::report
