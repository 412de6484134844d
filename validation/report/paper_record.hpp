// report.json of the paper's page. Keys: docs/report.md.
#pragma once

#include <string>

#include "paper/contents.hpp"
#include "report/origin.hpp"

namespace vcrit::validation::report {

struct PaperContents {
  Origin origin;
  paper::Paper paper;
};

using validation::passed;  // beside this
/// No comparison failed.
bool passed(const paper::Paper& paper);

/// Makes the report again.
extern const char* const paper_command;

std::string paper_json(const PaperContents& contents);

}  // namespace vcrit::validation::report
