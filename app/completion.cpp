// What the program answers to a shell that asks what may follow.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "problem/problem.hpp"
#include "shell.hpp"

namespace vcrit::app {

namespace {

constexpr const char* scenes = ":*.toml\n";
constexpr const char* all_files = ":*\n";
constexpr const char* folders = ":/\n";

bool is_option(const std::string& word) { return word.starts_with('-'); }

std::string offered(const std::string& word, const std::string& begun, const std::string& words) {
  return word.starts_with(begun) ? fmt::format("{}\t{}\n", word, words) : "";
}

std::string choices(const CLI::Option& option, const std::string& begun) {
  std::string out;
  for (const std::string& choice : choices_of(option)) out += offered(choice, begun, "");
  return out;
}

/// Nothing where nobody can know.
std::string values(const CLI::Option& option, const std::string& begun) {
  const std::string name = names_of(option).back(), type = option.get_type_name();
  if (!choices_of(option).empty()) return choices(option, begun);
  if (name == "SCENE" || type == "SCENE") return scenes;
  if (type == "DIR") return folders;
  const bool is_file = option.get_positional() || name == "--out" || type.starts_with("FILE");
  return is_file ? all_files : "";
}

/// The names that the first scene among the words lets be set or varied; none where it cannot be
/// read.
std::string names_in_scene(const std::vector<std::string>& words, const std::string& begun,
                           bool also_speeds) {
  std::string out;
  const auto scene = std::find_if(words.begin(), words.end(),
                                  [](const std::string& word) { return word.ends_with(".toml"); });
  if (scene == words.end()) return out;
  try {
    const Problem problem = read_problem(*scene);
    for (const auto& [name, dimension] : problem->source->settable)
      out += offered(name + "=", begun, describe(dimension));
    if (also_speeds)
      for (const char* speed : {"velocity=", "velocity_ratio="}) out += offered(speed, begun, "");
  } catch (const InputError&) {
    return "";
  }
  return out;
}

bool takes_names(const CLI::Option& option) {
  const std::string name = names_of(option).back();
  return choices_of(option).empty() && (name == "--set" || name == "--over");
}

std::string options(const CLI::App& command, const std::string& begun) {
  std::string out;
  for (const CLI::Option* option : options_of(command))
    for (const std::string& name : names_of(*option))
      if (is_option(name)) out += offered(name, begun, option->get_description());
  return out;
}

std::string commands(const CLI::App& program, const std::string& begun) {
  std::string out;
  for (const CLI::App* command : program.get_subcommands({}))
    if (!command->get_name().empty())
      out += offered(command->get_name(), begun, command->get_description());
  return out;
}

std::string positionals(const CLI::App& command, const std::string& begun) {
  for (const CLI::Option* option : options_of(command))
    if (option->get_positional()) return values(*option, begun);
  return "";
}

}  // namespace

std::string completions(const CLI::App& program, std::vector<std::string> words) {
  std::string begun = words.empty() || words.back() == "=" ? "" : words.back();
  if (!words.empty() && words.back() != "=") words.pop_back();
  if (const auto equals = begun.find('='); begun.starts_with("--") && equals != begun.npos) {
    words.push_back(begun.substr(0, equals));
    begun.erase(0, equals + 1);
  }
  std::erase(words, "=");

  const CLI::App* command = &program;
  const CLI::Option* option = nullptr;  // the last one
  for (const std::string& word : words) {
    if (is_option(word)) option = command->get_option_no_throw(word);
    if (command != &program) continue;
    const auto named = [&](const CLI::App* each) { return each->get_name() == word; };
    if (const auto found = program.get_subcommands(named); !found.empty()) command = found.front();
  }
  if (is_option(begun)) return options(*command, begun);
  const bool takes_value = option != nullptr && option->get_type_size() != 0;
  if (takes_value && is_option(words.back()))
    return takes_names(*option) ? names_in_scene(words, begun, names_of(*option).back() == "--over")
                                : values(*option, begun);
  if (command == &program) return commands(program, begun);
  // Behind an option of several values another one may follow as well.
  const bool takes_more = takes_value && is_repeated(*option) && option->get_allow_extra_args();
  return (takes_more ? choices(*option, begun) : "") + positionals(*command, begun);
}

}  // namespace vcrit::app
