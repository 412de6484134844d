#include "option_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vcrit::app {

namespace {

/// CLI11 puts choices behind the type: "TEXT:{exact,moreau}".
std::vector<std::string> choices_in(const std::string& type) {
  const auto open = type.find(":{"), close = type.find('}', open);
  if (open == type.npos) return {};
  return CLI::detail::split(type.substr(open + 2, close - open - 2), ',');
}

/// CLI11 gives each group of options a help flag of its own; only the command's counts.
void collect(const CLI::App& app, std::vector<Argument>& arguments) {
  for (const CLI::Option* option : app.get_options())
    if (option != app.get_help_ptr() || !app.get_name().empty())
      arguments.push_back(argument_of(*option));
  for (const CLI::App* group : app.get_subcommands({}))
    if (group->get_name().empty()) collect(*group, arguments);
}

Command command_of(const CLI::App& app, const std::string& name) {
  Command command{name, app.get_description(), app.get_footer(), {}};
  collect(app, command.arguments);
  // What has to be typed without a name comes first.
  std::stable_partition(command.arguments.begin(), command.arguments.end(),
                        [](const Argument& argument) { return argument.positional; });
  return command;
}

}  // namespace

Argument argument_of(const CLI::Option& option) {
  Argument argument;
  argument.positional = option.get_positional();
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  if (argument.positional) argument.names = {option.get_name(true, false)};
  const std::string type = option.get_type_name();
  if (option.get_type_size() != 0) argument.value = type.substr(0, type.find(':'));
  argument.choices = choices_in(type);
  argument.preset = option.get_default_str();
  argument.words = option.get_description();
  argument.required = option.get_required();
  argument.repeated = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  argument.greedy = argument.repeated && option.get_allow_extra_args();
  return argument;
}

std::vector<Command> commands_of(const CLI::App& program) {
  std::vector<Command> commands{command_of(program, "")};
  for (const CLI::App* command : program.get_subcommands({}))
    if (!command->get_name().empty()) commands.push_back(command_of(*command, command->get_name()));
  return commands;
}

std::string value_words(const Argument& argument) {
  std::string words;
  if (!argument.positional) words = argument.value;
  if (!argument.choices.empty()) words = fmt::format("{{{}}}", fmt::join(argument.choices, ","));
  if (!argument.preset.empty()) words += "=" + argument.preset;
  if (argument.repeated) words += words.empty() ? "..." : " ...";
  if (argument.required) words += words.empty() ? "required" : ", required";
  return words;
}

Kind kind_of(const Argument& argument) {
  if (argument.positional || argument.value == "SCENE") return Kind::scene;
  if (argument.value.empty()) return Kind::nothing;
  if (!argument.choices.empty()) return Kind::choice;
  if (argument.value == "DIR") return Kind::folder;
  const bool output = argument.names.back() == "--out" || argument.value.starts_with("FILE");
  return output ? Kind::file : Kind::text;
}

}  // namespace vcrit::app
