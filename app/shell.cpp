#include "shell.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <memory>

#include "base/joined.hpp"
#include "examples.hpp"
#include "shell_texts.hpp"

namespace vcrit::app {

namespace {

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string words = value_words(*option);
    return words.empty() ? "" : " " + words;
  }

  // A group of options; the help flag that CLI11 gives it belongs to the command.
  std::string make_expanded(const CLI::App* group) const override {
    std::string text = "\n" + group->get_group() + ":\n";
    if (group->get_require_option_max() == 1)
      text = group->get_require_option_min() == 1 ? "\nExactly one of:\n" : "\nAt most one of:\n";
    for (const CLI::Option* option : group->get_options())
      if (option != group->get_help_ptr()) text += make_option(option, false);
    return text;
  }

  // What must be given comes before what may be.
  std::string make_positionals(const CLI::App* app) const override {
    return CLI::Formatter::make_positionals(app) + groups_of(*app, true);
  }
  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override {
    const bool has_commands =
        !app->get_subcommands([](const CLI::App* below) { return !below->get_name().empty(); })
             .empty();
    return has_commands ? CLI::Formatter::make_subcommands(app, mode) : groups_of(*app, false);
  }

 private:
  std::string groups_of(const CLI::App& app, bool required) const {
    std::string text;
    for (const CLI::App* below : app.get_subcommands({}))
      if (below->get_name().empty() && (below->get_require_option_min() > 0) == required)
        text += make_expanded(below);
    return text;
  }
};

void set_formatter(CLI::App& app, const std::shared_ptr<HelpFormatter>& formatter) {
  app.formatter(formatter);
  for (CLI::App* below : app.get_subcommands({})) set_formatter(*below, formatter);
}

/// CLI11's way to print something in place of running a command, as for --version.
[[noreturn]] void print_instead(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  throw CLI::CallForVersion(text, 0);
}

/// CLI11 gives each group of options a help flag of its own; only the command's counts.
void collect(const CLI::App& app, std::vector<const CLI::Option*>& options) {
  for (const CLI::Option* option : app.get_options())
    if (option != app.get_help_ptr() || !app.get_name().empty() || app.get_parent() == nullptr)
      options.push_back(option);
  for (const CLI::App* group : app.get_subcommands({}))
    if (group->get_name().empty()) collect(*group, options);
}

}  // namespace

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options;
  collect(command, options);
  std::stable_partition(options.begin(), options.end(),
                        [](const CLI::Option* option) { return option->get_positional(); });
  return options;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_name(true, false)};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11 puts choices behind the type: "TEXT:{exact,moreau}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto open = type.find(":{"), close = type.find('}', open);
  if (open == type.npos) return {};
  return CLI::detail::split(type.substr(open + 2, close - open - 2), ',');
}

bool is_repeated(const CLI::Option& option) {
  return option.get_expected_max() == CLI::detail::expected_max_vector_size;
}

std::string value_words(const CLI::Option& option) {
  std::string words;
  const std::vector<std::string> choices = choices_of(option);
  const std::string type = option.get_type_name(), preset = option.get_default_str();
  if (!option.get_positional() && option.get_type_size() != 0)
    words = type.substr(0, type.find(':'));
  if (!choices.empty()) words = fmt::format("{{{}}}", joined(choices, ","));
  if (!preset.empty()) words += "=" + preset;
  if (is_repeated(option)) words += words.empty() ? "..." : " ...";
  if (option.get_required()) words += words.empty() ? "required" : ", required";
  return words;
}

void add_shell(CLI::App& program) {
  program.add_flag_callback(
      "--man", [&program] { print_instead(man_page(program)); }, "print the man page vcrit(1)");
  program
      .add_option_function<std::string>(
          "--completion",
          [](const std::string& shell) {
            print_instead(shell == "zsh" ? zsh_completion : bash_completion);
          },
          "print the completion for a shell")
      ->check(CLI::IsMember({"bash", "zsh"}));
  add_examples(program);
  set_formatter(program, std::make_shared<HelpFormatter>());
}

}  // namespace vcrit::app
