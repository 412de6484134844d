// vcrit validate: cross-checks of scenes, of the paper or at extreme numbers, as pages and one JSON
// file.
#include "report/validate.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <CLI/App.hpp>

#include <memory>

#include "base/errors.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "program.hpp"
#include "record/fields.hpp"
#include "report/validate_extremes.hpp"
#include "run/workers.hpp"
#include "streams.hpp"

namespace vcrit::record {

using validation::report::Validation, validation::report::ComparisonVerdict;

void fields(Fields& f, const ComparisonVerdict& it) {
  f("subject", it.subject)("key", it.key)("name", it.name)("outcome", it.outcome);
}

void fields(Fields& f, const Validation& it) {
  f("passed", it.passed)("comparisons", it.verdicts)("warnings", it.warnings);
  f("page", it.page)("files", it.files);
}

}  // namespace vcrit::record

namespace vcrit::app {

namespace {

using validation::report::Validation;

constexpr std::size_t bar_width = 20;  // of the usual 79, so that names of scenes fit beside it

/// Of the terminal on stderr; a longer line would not be written over.
std::size_t line_width() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col - 1u : 79;
}

/// One line on stderr that is written over; nothing in a pipe.
void show_progress(const validation::Standing& standing) {
  if (isatty(STDERR_FILENO) == 0) return;
  const std::size_t filled = bar_width * standing.done / standing.jobs;
  std::string line =
      fmt::format("[{}{}] {}/{}", std::string(filled, '='), std::string(bar_width - filled, ' '),
                  standing.done, standing.jobs);
  for (const auto& [name, step] : standing.running) line += fmt::format("  {}: {}", name, step);
  tell("\r\033[K{}", line.substr(0, line_width()));
}

void clear_progress() {
  if (isatty(STDERR_FILENO) != 0) tell("\r\033[K");
}

void print_validation(const Validation& validation, bool json) {
  for (const std::string& warning : validation.warnings) warn(warning);
  for (const std::string& line : validation.not_run) warn("not run: " + line);
  for (const std::string& line : validation.failed) tell_line("vcrit: FAILED: " + line);
  if (json) return print(record::json_of(validation));
  fmt::print("{}\n", validation.page.string());
}

struct ValidateOptions {
  validation::report::Request request;
  bool paper = false, extremes = false, json = false;
};

Validation validated(const ValidateOptions& options) {
  const validation::report::Request& request = options.request;
  const char* const instead = options.paper ? "--paper" : "--extremes";
  if (options.paper && options.extremes)
    throw InputError({"--extremes"}, "--paper as well", "one or the other");
  if ((options.paper || options.extremes) && !request.files.empty())
    throw InputError({instead}, "scene files as well", "one or the other");
  if (options.paper) return validation::report::validate_paper(request, show_progress);
  if (options.extremes) return validation::report::validate_extremes(request, show_progress);
  if (request.files.empty())
    throw InputError({"SCENE"}, "none", "scene files, --paper or --extremes");
  return validation::report::validate(request, show_progress);
}

Validation in_jobs(const ValidateOptions& options) {
  try {
    return validated(options);
  } catch (const validation::JobRefused& error) {
    throw Refused(with_options(error.what()));
  }
}

}  // namespace

void add_validate(CLI::App& program, int& status) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = program.add_subcommand(
      "validate", "Compare formula, evaluators and simulation; write a report");
  command->add_option("SCENE", options->request.files, "scene files (TOML)");
  command->add_flag("--paper", options->paper,
                    "instead of scenes: the paper's equations, figures and numbers");
  command->add_flag("--extremes", options->extremes,
                    "instead of scenes: evaluators and simulator at extreme numbers");
  command->add_option("--out", options->request.directory, "folder for index.html and report.json")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--figures", options->request.figures, "folder for the figures as SVG and PDF")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, &status] {
    const Validation validation = in_jobs(*options);
    clear_progress();
    print_validation(validation, options->json);
    if (!validation.passed) status = 1;
  });
}

}  // namespace vcrit::app
