// What a table of scenes says of each: enough for an index, small enough to be handed between
// processes.
#pragma once

#include <string>
#include <vector>

#include "compare/scene_report.hpp"
#include "record/fields.hpp"

namespace vcrit::validation::report {

struct SceneLine {
  std::string file, title;
  std::string state;         ///< class of the style sheet: "passed", "failed", "not-run", "outside"
  std::string state_words;   ///< "9 comparisons passed"
  std::string velocity;      ///< "v* = 4.1 mm/s"
  std::string tightest;      ///< which comparison is nearest to its tolerance, or farthest beyond
  std::string answer_words;  ///< "4.095 mm/s", or why there is no answer
  std::string reduction;     ///< "−25 %"; empty where it is not known
  std::string frequency;     ///< "20 kHz"
  std::string spark;         ///< friction over speed as a path of 96 x 28 pixels; may be empty
  std::string spark_onset;   ///< where v* is on it
  std::size_t made = 0;      ///< comparisons that could be made
  std::vector<std::string> failed, not_run;  ///< names of comparisons
  std::vector<std::string> warnings;         ///< of reading the scene
};

SceneLine scene_line(const SceneReport& report);
/// The line of which that is the record.
SceneLine scene_line(const record::Json& json);

}  // namespace vcrit::validation::report

namespace vcrit::record {

void fields(Fields& f, const validation::report::SceneLine& line);

}  // namespace vcrit::record
