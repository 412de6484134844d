// report.json: the data of the page, for programs. Keys: docs/report.md.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/origin.hpp"
#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// What report.json says of one scene.
nlohmann::ordered_json scene_json(const SceneContents& contents);

/// The whole file; scenes as by scene_json().
std::string report_json(const Origin& origin, const std::vector<nlohmann::ordered_json>& scenes);

/// "vcrit validate A B --out report", for a shell.
std::string command(const std::vector<std::string>& scene_files);

}  // namespace vcrit::validation::report
