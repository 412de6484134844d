#include "shell.hpp"

#include <memory>

#include "examples.hpp"

namespace vcrit::app {

namespace {

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string words = value_words(argument_of(*option));
    return words.empty() ? "" : " " + words;
  }

  // A group of options; the help flag that CLI11 gives it belongs to the command.
  std::string make_expanded(const CLI::App* group) const override {
    std::string text = group->get_require_option_max() == 1 ? "\nExactly one of:\n"
                                                            : "\n" + group->get_group() + ":\n";
    for (const CLI::Option* option : group->get_options())
      if (option != group->get_help_ptr()) text += make_option(option, false);
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

}  // namespace

void add_shell(CLI::App& program) {
  program.add_flag_callback(
      "--man", [&program] { print_instead(man_page(commands_of(program))); },
      "print the man page vcrit(1)");
  program
      .add_option_function<std::string>(
          "--completion",
          [&program](const std::string& shell) {
            const std::vector<Command> commands = commands_of(program);
            print_instead(shell == "zsh" ? zsh_completion(commands) : bash_completion(commands));
          },
          "print the completion for a shell")
      ->check(CLI::IsMember({"bash", "zsh"}));
  add_examples(program);
  set_formatter(program, std::make_shared<HelpFormatter>());
}

}  // namespace vcrit::app
