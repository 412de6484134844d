#include "report/report_json.hpp"

#include <algorithm>

#include "report/html.hpp"
#include "report/records.hpp"

namespace vcrit::validation::report {

using nlohmann::ordered_json;

ordered_json scene_json(const SceneContents& contents) { return record::json_of(contents); }

std::string command(const std::vector<std::string>& scene_files) {
  std::string text = "vcrit validate";
  for (const std::string& file : scene_files) text += " " + shell_word(file);
  return text + " --out report";
}

std::string report_json(const Origin& origin, const std::vector<ordered_json>& scenes) {
  const bool passed = std::all_of(scenes.begin(), scenes.end(), [](const ordered_json& scene) {
    return scene.at("passed").get<bool>();
  });
  ordered_json report = report_head(origin, passed);
  report["scenes"] = scenes;
  return text_of(report);
}

}  // namespace vcrit::validation::report
