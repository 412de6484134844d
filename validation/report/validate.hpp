// `vcrit validate`: scenes in, or the paper, one report out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/paper_record.hpp"
#include "report/scene_contents.hpp"
#include "report/validation.hpp"
#include "run/workers.hpp"

namespace vcrit::validation::report {

struct Request {
  std::vector<std::string> files;   ///< scenes
  std::filesystem::path directory;  ///< for the report
  std::filesystem::path figures;    ///< for the figures as files; empty: none
};

/// Throws InputError where its files cannot be written: before the work, not behind it.
void check_places(const Request& request);

/// Everything compared with everything of one scene.
SceneContents compare(const Problem& problem, const Progress& step);

/// The same for each scene file and writes DIR/report.json with
/// all data and DIR/index.html: the page of the scene, or of several an index with a line
/// each, and their pages beside it under the files' names. Scenes are read first and worked on side
/// by side, as many as there are cores. Figures go below the folder that is named after the page,
/// of one scene to the folder itself. Throws InputError and ModelError; then nothing is written.
Validation validate(const Request& request, const Watch& watch);

/// Goes through the paper and writes the same two files about it, and its figures. The request has
/// no scenes. Throws InputError; then nothing is written.
Validation validate_paper(const Request& request, const Watch& watch);

/// The second half of it: the verdict and the files.
Validation report_paper(const PaperContents& contents, const Request& request, const Watch& watch);

}  // namespace vcrit::validation::report
