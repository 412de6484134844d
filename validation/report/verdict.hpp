// How a scene or a page came out, in a few words, for the pages and the table of scenes.
#pragma once

#include <string>
#include <vector>

#include "compare/scene_report.hpp"

namespace vcrit::validation::report {

/// The scene's title, or its file's name.
std::string title_of(const SceneReport& report);

/// "failed", "passed", "not-run" or "outside": how the scene is marked.
const char* state_class(const SceneReport& report);
/// "1 of 9 comparisons failed", "outside the model: not simulated", ...
std::string state_words(const SceneReport& report);
/// What vibration does to this contact, or why there is no answer.
std::string sentence_of(const SceneReport& report);
/// What stands above a report of which checks failed.
std::string warning_of_failed(const SceneReport& report);
/// "9 checks passed: the closest used 0.5 % of its tolerance."
std::string checks_words(const SceneReport& report);
/// "v* = 3.02 mm/s"
std::string velocity_words(const SceneReport& report);

/// "12 comparisons passed, 2 not run"
std::string count_words(std::size_t made, std::size_t failed, std::size_t not_run);
std::string count_words(const std::vector<Comparison>& comparisons);

/// Which is nearest to its tolerance, or why one broke; empty where none was made.
std::string tightest_words(const std::vector<Comparison>& comparisons);

}  // namespace vcrit::validation::report
