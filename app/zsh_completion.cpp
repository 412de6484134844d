// Completion for zsh: one _arguments call for each command.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shell.hpp"

namespace vcrit::app {

namespace {

constexpr const char* zsh_head = R"(#compdef vcrit
# vcrit completion for zsh, printed by `vcrit --completion zsh`.
_vcrit() {
  local curcontext="$curcontext" state line
  typeset -A opt_args
  local -a commands=(
)";

constexpr const char* zsh_tail = R"(  esac
}

# Loaded from a folder in fpath this file is the function itself; else it is sourced.
if [[ ${funcstack[1]} == _vcrit ]]; then
  _vcrit "$@"
else
  compdef _vcrit vcrit
fi
)";

/// In single quotes, `special` characters behind a backslash.
std::string quoted(const std::string& text, const std::string& special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != special.npos) out += '\\';
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out;
}

std::string zsh_action(const Argument& argument) {
  switch (kind_of(argument)) {
    case Kind::choice:
      return fmt::format("({})",
                         quoted(fmt::format("{}", fmt::join(argument.choices, " ")), ":\\"));
    case Kind::scene:
      return "_files -g \"*.toml\"";
    case Kind::folder:
      return "_files -/";
    case Kind::file:
      return "_files";
    case Kind::text:
    case Kind::nothing:
      break;
  }
  return " ";
}

/// One specification a name: '*--set=[words]:NAME=VALUE: '.
std::string specifications(const Argument& argument, const std::string& indent) {
  if (argument.positional)
    return fmt::format("{}'*:{}:{}'", indent, argument.names.front(), zsh_action(argument));
  std::string out;
  for (const std::string& name : argument.names) {
    const bool value = kind_of(argument) != Kind::nothing;
    const bool lengthy = value && name.starts_with("--");
    out += fmt::format("{}'{}{}{}[{}]", indent, argument.repeated ? "*" : "", name,
                       lengthy ? "=" : "", quoted(argument.words, "[]\\"));
    if (value) out += fmt::format(":{}:{}", quoted(argument.value, ":\\"), zsh_action(argument));
    out += "'";
  }
  return out;
}

std::string all_specifications(const Command& command, const std::string& indent) {
  std::string out;
  for (const Argument& argument : command.arguments) out += specifications(argument, indent);
  return out;
}

}  // namespace

std::string zsh_completion(const std::vector<Command>& commands) {
  std::string out = zsh_head;
  for (const Command& command : commands)
    if (!command.name.empty())
      out += fmt::format("    '{}:{}'\n", command.name, quoted(command.words, ":\\"));
  out += "  )\n  _arguments -C" + all_specifications(commands.front(), " \\\n    ") +
         " \\\n    '1: :{_describe command commands}' '*:: :->rest' && return 0\n"
         "  [[ $state == rest ]] || return 1\n  case ${line[1]} in\n";
  for (const Command& command : commands)
    if (!command.name.empty())
      out += fmt::format("    {}) _arguments{} ;;\n", command.name,
                         all_specifications(command, " \\\n      "));
  return out + zsh_tail;
}

}  // namespace vcrit::app
