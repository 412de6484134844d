// report.json: the data of the page, for programs. Keys: docs/report.md.
#pragma once

#include <string>
#include <vector>

#include "machine.hpp"
#include "scene_report.hpp"

namespace vcrit::validation::report {

/// What one report is about.
struct Contents {
  Machine machine;
  std::vector<SceneReport> scenes;
};

bool passed(const Contents& contents);

/// The command that makes this report again.
std::string command(const Contents& contents);

std::string report_json(const Contents& contents);

}  // namespace vcrit::validation::report
