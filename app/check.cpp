// vcrit check: all problems of scenes at once, and which commands answer for scenes without errors.
// The problems are what was asked for, so they are printed on stdout.
#include <fmt/core.h>
#include <unistd.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "answering.hpp"
#include "base/files.hpp"
#include "base/joined.hpp"
#include "base/plain_text.hpp"
#include "base/sort_stably.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "problem/findings.hpp"
#include "record/fields.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::app {

namespace {

enum CheckStatus { all_well = 0, some_wrong = 2, some_outside = 3 };

/// An error, or a warning, which has no parts.
struct SceneProblem {
  Place place;
  bool is_error = true;
  std::string text;
  std::string found, expected, advice;

  friend void fields(record::Fields& f, const SceneProblem& it) {
    f("file", it.place.file).when(it.place.line > 0, "line", it.place.line);
    f.when(it.place.line > 0, "column", it.place.column);
    f("kind", it.is_error ? "error" : "warning")("text", it.text);
    f.some("found", it.found).some("expected", it.expected).some("advice", it.advice);
  }
};

SceneProblem problem_of(const InputError& error) {
  std::string text = fmt::format("{}; expected {}", error.found(), error.expected());
  if (!error.advice().empty()) text += "; " + error.advice();
  return {error.place(), true, text, error.found(), error.expected(), error.advice()};
}

struct CheckedScene {
  std::string file, text;
  std::vector<SceneProblem> problems;
  bool is_outside = false;  // of the model
  std::vector<CommandAnswer> commands;

  std::size_t count(bool errors) const {
    return static_cast<std::size_t>(
        std::count_if(problems.begin(), problems.end(),
                      [errors](const SceneProblem& each) { return each.is_error == errors; }));
  }

  friend void fields(record::Fields& f, const CheckedScene& it) {
    f("file", it.file)("problems", it.problems)("outside_the_model", it.is_outside);
    f("commands", it.commands);
  }
};

struct CheckedScenes {
  std::vector<CheckedScene> scenes;

  std::size_t count(bool errors) const {
    std::size_t sum = 0;
    for (const CheckedScene& scene : scenes) sum += scene.count(errors);
    return sum;
  }
  int status() const {
    if (count(true) > 0) return some_wrong;
    const bool outside = std::any_of(scenes.begin(), scenes.end(),
                                     [](const CheckedScene& scene) { return scene.is_outside; });
    return outside ? some_outside : all_well;
  }

  friend void fields(record::Fields& f, const CheckedScenes& it) {
    f("scenes", it.scenes)("error_count", it.count(true))("warning_count", it.count(false));
    f("status", it.status());
  }
};

// Only where there are values enough to know.
void add_model_warning(CheckedScene& scene, const Problem& problem) {
  try {
    const rules::Answer found = rules::answer(rules::Question::admissible, problem);
    if (found) return;
    scene.is_outside = true;
    const std::string words = "outside the model: " + found.reason;
    scene.problems.push_back({{scene.file},
                              false,
                              found.advice.empty() ? words : words + "; " + found.advice,
                              "",
                              "",
                              found.advice});
  } catch (const InputError&) {  // answering_commands() names what is missing
  } catch (const ModelError&) {
  }
}

CheckedScene checked_scene(const std::string& file) {
  CheckedScene scene{file, read_file(file), {}, false, {}};
  const ProblemFindings found = examine_problem(scene.text, file);
  for (const InputError& error : found.errors) scene.problems.push_back(problem_of(error));
  for (const Warning& warning : found.warnings)
    scene.problems.push_back({warning.place.file.empty() ? Place{file} : warning.place, false,
                              warning.text, "", "", ""});
  if (found.problem) {
    add_model_warning(scene, *found.problem);
    scene.commands = answering_commands(*found.problem);
  }
  sort_stably(scene.problems, [](const SceneProblem& a, const SceneProblem& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  return scene;
}

// All scenes are read before the first line is printed.
CheckedScenes checked_scenes(const std::vector<std::string>& files) {
  CheckedScenes all;
  for (const std::string& file : files) all.scenes.push_back(checked_scene(file));
  return all;
}

std::string source_line(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line && begin < text.size(); ++i)
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  std::string found = text.substr(begin, text.find('\n', begin) - begin);
  if (found.ends_with('\r')) found.pop_back();
  return found;
}

// For people who have the line before them; columns count characters.
void print_caret(const CheckedScene& scene, const Place& place) {
  if (place.line == 0 || place.file != scene.file) return;
  const std::string line = source_line(scene.text, place.line);
  std::string blanks;
  int column = 1;
  for (std::size_t i = 0; i < line.size() && column < place.column; ++i) {
    if ((byte_at(line, i) & 0xC0U) == 0x80U) continue;
    blanks += line[i] == '\t' ? '\t' : ' ';
    ++column;
  }
  fmt::print("{:>5} | {}\n      | {}^\n", place.line, without_steering(line), blanks);
}

void print_problems(const CheckedScene& scene) {
  std::size_t width = 0;
  for (const SceneProblem& each : scene.problems)
    width = std::max(width, to_text(each.place).size());
  const bool shows_lines = isatty(STDOUT_FILENO) == 1;
  for (const SceneProblem& each : scene.problems) {
    fmt::print("{}\n", one_line(fmt::format("{:<{}}  {:<7}  {}", to_text(each.place), width,
                                            each.is_error ? "error" : "warning", each.text)));
    if (shows_lines) print_caret(scene, each.place);
  }
}

// Commands of one reason together, in the order of the first of each.
void print_commands(const std::vector<CommandAnswer>& commands) {
  std::vector<std::string> answering;
  std::vector<std::pair<std::string, std::vector<std::string>>> refusing;
  for (const CommandAnswer& each : commands) {
    if (each.answers) {
      answering.push_back(each.command);
      continue;
    }
    const std::string reason = each.advice.empty() ? each.reason : each.reason + "; " + each.advice;
    const auto known = std::find_if(refusing.begin(), refusing.end(),
                                    [&](const auto& row) { return row.first == reason; });
    if (known == refusing.end())
      refusing.push_back({reason, {each.command}});
    else
      known->second.push_back(each.command);
  }
  fmt::print("; these commands answer: {}\n", joined(answering, ", "));
  for (const auto& [reason, names] : refusing)
    fmt::print("  not {}: {}\n", joined(names, ", "), one_line(reason));
  for (const CommandAnswer& each : commands)
    for (const std::string& part : each.left_out)
      fmt::print("  {} leaves out {}\n", each.command, one_line(part));
}

std::string counted(std::size_t number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

void print_checked(const CheckedScene& scene) {
  print_problems(scene);
  const std::size_t errors = scene.count(true), warnings = scene.count(false);
  const std::string in_file = one_line(scene.file);
  if (errors > 0) {
    fmt::print("{}: {}, {}. Nothing was computed.\n", in_file, counted(errors, "error"),
               counted(warnings, "warning"));
    return;
  }
  fmt::print("{}: {}{}", in_file, warnings == 0 ? "no problems" : counted(warnings, "warning"),
             scene.is_outside ? ", outside the model" : "");
  print_commands(scene.commands);
}

}  // namespace

void add_check(CLI::App& program, int& status) {
  struct CheckOptions {
    std::vector<std::string> files;
    bool json = false;
  };
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand(
      "check", "All that is wrong with scenes, at once, and which commands answer");
  command->add_option("SCENE", options->files, "scene files (TOML)")->required();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, &status] {
    const CheckedScenes checked = checked_scenes(options->files);
    if (options->json)
      print(record::json_of(checked));
    else
      for (const CheckedScene& scene : checked.scenes) print_checked(scene);
    status = checked.status();
  });
}

}  // namespace vcrit::app
