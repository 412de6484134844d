// report.json of the page about extremes. Keys: docs/report.md.
#pragma once

#include <string>

#include "extremes/contents.hpp"
#include "report/origin.hpp"

namespace vcrit::validation::report {

struct ExtremesContents {
  Origin origin;
  extremes::Extremes extremes;
};

using validation::passed;  // beside this
/// No comparison failed.
bool passed(const extremes::Extremes& extremes);

/// Makes the report again.
extern const char* const extremes_command;

std::string extremes_json(const ExtremesContents& contents);

}  // namespace vcrit::validation::report
