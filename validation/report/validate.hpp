// `vcrit validate`: scenes in, one report out.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vcrit::validation::report {

struct Validation {
  bool passed = true;                 ///< no comparison failed
  std::vector<std::string> failed;    ///< "scenes/zener.toml: stick-slip simulation"
  std::vector<std::string> not_run;   ///< the same for comparisons that could not be made
  std::vector<std::string> warnings;  ///< of reading the scenes
  std::filesystem::path page;         ///< DIR/index.html
};

/// Told which scene (from 0) of how many is at which step.
using SceneProgress =
    std::function<void(std::size_t scene, std::size_t scenes, const std::string& step)>;

/// Compares everything with everything in each scene file and writes `directory`/index.html, one
/// page that needs nothing else, and `directory`/report.json with the same data. All scenes are
/// read first. Throws InputError and ModelError; then nothing is written.
Validation validate(const std::vector<std::string>& files, const std::filesystem::path& directory,
                    const SceneProgress& progress);

/// Goes through the paper and writes the same two files about it.
Validation validate_paper(const std::filesystem::path& directory,
                          const std::function<void(const std::string& step)>& progress);

}  // namespace vcrit::validation::report
