// vcrit validate: everything compared with everything, of scenes or of the paper, as one page and
// one JSON file.
#include "report/validate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "base/errors.hpp"
#include "commands.hpp"

namespace vcrit::app {

namespace {

using validation::report::Validation;

/// One line on stderr that is written over; nothing in a pipe.
void show_progress(std::size_t scene, std::size_t scenes, const std::string& step) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K[{}/{}] {}", scene + 1, scenes, step);
  std::fflush(stderr);
}

void clear_progress() {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

void print(const Validation& validation) {
  for (const std::string& warning : validation.warnings)
    fmt::print(stderr, "vcrit: warning: {}\n", warning);
  for (const std::string& line : validation.not_run)
    fmt::print(stderr, "vcrit: warning: not run: {}\n", line);
  for (const std::string& line : validation.failed) fmt::print(stderr, "vcrit: FAILED: {}\n", line);
  fmt::print("{}\n", validation.page.string());
}

struct Options {
  std::vector<std::string> scenes;
  bool paper = false;
  std::string directory;
};

Validation validated(const Options& options) {
  if (options.paper && !options.scenes.empty())
    throw InputError({"--paper"}, "scene files beside it", "one or the other");
  if (!options.paper && options.scenes.empty())
    throw InputError({"SCENE"}, "none", "scene files, or --paper");
  if (!options.paper)
    return validation::report::validate(options.scenes, options.directory, show_progress);
  return validation::report::validate_paper(
      options.directory, [](const std::string& step) { show_progress(0, 1, step); });
}

}  // namespace

void add_validate(CLI::App& program, int& status) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "validate", "Compare formula, evaluators and simulation; write a report");
  command->add_option("SCENE", options->scenes, "scene files (TOML)");
  command->add_flag("--paper", options->paper,
                    "instead of scenes: the paper's equations, figures and numbers");
  command->add_option("--out", options->directory, "folder for index.html and report.json")
      ->required()
      ->type_name("DIR");
  command->callback([options, &status] {
    const Validation validation = validated(*options);
    clear_progress();
    print(validation);
    if (!validation.passed) status = 1;
  });
}

}  // namespace vcrit::app
