// vcrit(1) in the man macros of roff: the frame in shell/vcrit.1, filled with commands and options.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include "base/joined.hpp"
#include "shell.hpp"
#include "shell_texts.hpp"

namespace vcrit::app {

namespace {

/// Text that roff prints as it stands.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
      continue;
    }
    if (c == '-') out += '\\';
    out += c;
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// The same in lines that one can read in the source.
std::string filled(const std::string& text) {
  constexpr std::size_t width = 78;  // a terminal has 80
  std::string out, line;
  for (const std::string& word : CLI::detail::split(text, ' ')) {
    if (!line.empty() && line.size() + word.size() >= width) {
      out += escaped(line) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + escaped(line);
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string entries(const CLI::App& command) {
  std::string out;
  for (const CLI::Option* option : options_of(command)) {
    std::vector<std::string> names;
    for (const std::string& name : names_of(*option))
      names.push_back(option->get_positional() ? italic(name) : bold(name));
    const std::string words = value_words(*option);
    out += fmt::format(".TP\n{}{}\n{}\n", joined(names, ", "),
                       words.empty() ? "" : " " + italic(words), filled(option->get_description()));
  }
  return out;
}

/// Lines as they are, without filling.
std::string block(const std::string& text) {
  std::string out = ".nf\n";
  for (const std::string& line : CLI::detail::split(text, '\n')) out += escaped(line) + "\n";
  return out + ".fi\n";
}

/// "vcrit eval SCENE [OPTIONS]"
std::string synopsis(const CLI::App& command) {
  std::string out = fmt::format("{} {}", bold("vcrit"), bold(command.get_name()));
  for (const CLI::Option* option : options_of(command))
    if (option->get_positional())
      out += (option->get_required() ? " " : " [") + italic(names_of(*option).front()) +
             (is_repeated(*option) ? "..." : "") + (option->get_required() ? "" : "]");
  return out + fmt::format(" [{}]\n", italic("OPTIONS"));
}

}  // namespace

std::string man_page(const CLI::App& program) {
  std::string all, sections;
  for (const CLI::App* command : program.get_subcommands({})) {
    all += synopsis(*command);
    sections += fmt::format(".SS {}\n{}.\n{}.PP\n{}", escaped(command->get_name()),
                            filled(command->get_description()), entries(*command),
                            block(command->get_footer()));
  }
  // Without the heading that a help has.
  const std::string examples = program.get_footer().substr(std::string("Examples:\n").size());
  return fmt::format(fmt::runtime(man_page_frame), fmt::arg("date", VCRIT_DATE),
                     fmt::arg("version", VCRIT_VERSION), fmt::arg("synopsis", all),
                     fmt::arg("options", entries(program)), fmt::arg("commands", sections),
                     fmt::arg("examples", block(examples)));
}

}  // namespace vcrit::app
