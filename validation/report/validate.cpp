#include "validate.hpp"

#include "agreement.hpp"
#include "base/files.hpp"
#include "paper/paper.hpp"
#include "report/assets.hpp"
#include "report/page.hpp"
#include "report/paper_page.hpp"
#include "report/report_json.hpp"

namespace vcrit::validation::report {

namespace {

/// Missing values are the reader's fault, and are told before the first long computation.
std::vector<Scene> read_all(const std::vector<std::string>& files) {
  std::vector<Scene> scenes;
  for (const std::string& file : files) {
    scenes.push_back(read_scene(file));
    values_of(scenes.back());
  }
  return scenes;
}

void summarise(const SceneReport& report, Validation& validation) {
  for (const Comparison& comparison : report.comparisons) {
    const std::string line = report.scene.file + ": " + comparison.name;
    if (outcome(comparison) == Comparison::Outcome::failed) validation.failed.push_back(line);
    if (outcome(comparison) == Comparison::Outcome::not_run) validation.not_run.push_back(line);
  }
  for (const std::string& warning : report.scene.warnings) validation.warnings.push_back(warning);
}

/// With the versions of what draws the page.
Machine described_machine() {
  Machine machine = this_machine();
  for (const Script& script : scripts()) machine.versions.emplace_back(script.name, script.version);
  return machine;
}

std::filesystem::path write(const std::filesystem::path& directory, const std::string& html,
                            const std::string& json) {
  write_file(directory / "report.json", json);
  write_file(directory / "index.html", html);
  return directory / "index.html";
}

}  // namespace

Validation validate(const std::vector<std::string>& files, const std::filesystem::path& directory,
                    const SceneProgress& progress) {
  const std::vector<Scene> scenes = read_all(files);
  Contents contents;
  contents.machine = described_machine();
  Validation validation;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    contents.scenes.push_back(
        agree(scenes[i], [&](const std::string& step) { progress(i, scenes.size(), step); }));
    summarise(contents.scenes.back(), validation);
  }
  validation.passed = validation.failed.empty();
  validation.page = write(directory, page(contents), report_json(contents));
  return validation;
}

Validation validate_paper(const std::filesystem::path& directory,
                          const std::function<void(const std::string& step)>& progress) {
  const PaperContents contents{described_machine(), paper::go_through(progress)};
  Validation validation;
  for (const Comparison& comparison : all_comparisons(contents.paper))
    if (outcome(comparison) == Comparison::Outcome::failed)
      validation.failed.push_back("the paper: " + comparison.name);
  validation.passed = validation.failed.empty();
  validation.page = write(directory, paper_page(contents), paper_json(contents));
  return validation;
}

}  // namespace vcrit::validation::report
