// vcrit(1) in the man macros of roff.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shell.hpp"

namespace vcrit::app {

namespace {

constexpr const char* program_description =
    R"(.SH DESCRIPTION
.B vcrit
finds the velocity up to which ultrasonic normal oscillation reduces sliding
friction, for any linear viscoelastic contact, drive and mass: as a formula
derived for the case at hand, as a number with a bound on its error, as
generated code, and by a stick\-slip simulation that knows nothing of the
formula. A
.I SCENE
is a TOML file that says what is there. The result alone goes to standard
output, warnings and errors to standard error.
)";

constexpr const char* exit_status =
    R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
A comparison that the command was asked to make failed.
.TP
.B 2
The input is wrong: the message names file, line, what was found and what was
expected. Nothing is written.
.TP
.B 3
The scene is well formed but outside the model: not admissible, for commands
that need it to be, or the value is 0/0.
.TP
.B 70
A fault of vcrit itself. Please report it, with the scene.
)";

constexpr const char* environment =
    R"(.SH ENVIRONMENT
.TP
.B UDUNITS2_XML_PATH
The database of units, in place of the one that is installed.
.TP
.B TMPDIR
Where validate compiles and runs generated code, in place of /tmp.
)";

constexpr const char* see_also =
    R"(.SH SEE ALSO
.BR units (7),
.BR udunits2 (1),
.BR gnuplot (1),
.BR mpirun (1)
)";

/// Without the heading that a help has.
std::string without_heading(const std::string& examples) {
  const std::string heading = "Examples:\n";
  return examples.starts_with(heading) ? examples.substr(heading.size()) : examples;
}

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
  constexpr std::size_t width = 78;
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

std::string entry(const Argument& argument) {
  std::vector<std::string> names;
  for (const std::string& name : argument.names)
    names.push_back(argument.positional ? italic(name) : bold(name));
  const std::string words = value_words(argument);
  return fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "),
                     words.empty() ? "" : " " + italic(words), filled(argument.words));
}

/// Lines as they are, without filling.
std::string block(const std::string& text) {
  std::string out = ".nf\n";
  for (const std::string& line : CLI::detail::split(text, '\n')) out += escaped(line) + "\n";
  return out + ".fi\n";
}

std::string synopsis(const std::vector<Command>& commands) {
  std::string out = ".SH SYNOPSIS\n.nf\n";
  for (const Command& command : commands) {
    if (command.name.empty()) continue;
    out += fmt::format("{} {}", bold("vcrit"), bold(command.name));
    for (const Argument& argument : command.arguments)
      if (argument.positional)
        out += (argument.required ? " " : " [") + italic(argument.names.front()) +
               (argument.repeated ? "..." : "") + (argument.required ? "" : "]");
    out += fmt::format(" [{}]\n", italic("OPTIONS"));
  }
  return out + bold("vcrit") + " " + bold("--version") + "\n.fi\n";
}

std::string section(const Command& command) {
  std::string out = fmt::format(".SS {}\n{}.\n", escaped(command.name), filled(command.words));
  for (const Argument& argument : command.arguments) out += entry(argument);
  return out + ".PP\n" + block(command.examples);
}

}  // namespace

std::string man_page(const std::vector<Command>& commands) {
  std::string out = fmt::format(
      ".TH VCRIT 1 {} \"vcrit {}\"\n.SH NAME\nvcrit \\- critical velocity of friction control by "
      "normal oscillation\n",
      VCRIT_DATE, VCRIT_VERSION);
  out += synopsis(commands) + program_description + ".SH OPTIONS\n";
  for (const Argument& argument : commands.front().arguments) out += entry(argument);
  out += ".SH COMMANDS\n";
  for (const Command& command : commands)
    if (!command.name.empty()) out += section(command);
  return out + exit_status + environment + ".SH EXAMPLES\n" +
         block(without_heading(commands.front().examples)) + see_also;
}

}  // namespace vcrit::app
