// report.json of the paper's page. Keys: docs/report.md.
#pragma once

#include <string>

#include "machine.hpp"
#include "paper/contents.hpp"

namespace vcrit::validation::report {

struct PaperContents {
  Machine machine;
  paper::Paper paper;
};

/// No comparison failed.
bool passed(const paper::Paper& paper);

/// Makes the report again.
extern const char* const paper_command;

std::string paper_json(const PaperContents& contents);

}  // namespace vcrit::validation::report
