// vcrit validate: everything compared with everything, as one page and one JSON file.
#include "report/validate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

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

}  // namespace

void add_validate(CLI::App& program, int& status) {
  struct Options {
    std::vector<std::string> scenes;
    std::string directory;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "validate", "Compare formula, evaluators and simulation; write a report");
  command->add_option("SCENE", options->scenes, "scene files (TOML)")->required();
  command->add_option("--out", options->directory, "folder for index.html and report.json")
      ->required()
      ->type_name("DIR");
  command->callback([options, &status] {
    const Validation validation =
        validation::report::validate(options->scenes, options->directory, show_progress);
    clear_progress();
    print(validation);
    if (!validation.passed) status = 1;
  });
}

}  // namespace vcrit::app
