// Completion for bash. It stands on COMP_WORDS alone and needs no package of helpers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shell.hpp"

namespace vcrit::app {

namespace {

constexpr const char* bash_head =
    R"(# vcrit completion for bash, printed by `vcrit --completion bash`.
_vcrit() {
  local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} i command= greedy=
  if [[ $word == '=' ]]; then
    word=
  elif [[ $option == '=' ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
      COMMANDS) [[ $command ]] || command=${COMP_WORDS[i]} ;;
      -*) greedy=${COMP_WORDS[i]} ;;
    esac
  done
  COMPREPLY=()
  [[ $word == -* ]] || case "$command $option" in
)";

constexpr const char* bash_middle = R"(  esac
  [[ $word == -* ]] || case "$command $greedy" in
)";

constexpr const char* bash_options = R"(  esac
  case "$command" in
)";

constexpr const char* bash_tail = R"(  esac
  [[ $word == -* ]] || _vcrit_files "$word" '!*.toml'
}

# _vcrit_words WORD CANDIDATES
_vcrit_words() { mapfile -t COMPREPLY < <(compgen -W "$2" -- "$1"); }

# _vcrit_files WORD LEFT-OUT: folders, and files but those that match
_vcrit_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$1"; compgen -f -X "$2" -- "$1" |
    while IFS= read -r file; do [[ -d $file ]] || printf '%s\n' "$file"; done)
}

complete -F _vcrit vcrit
)";

/// What completes the value of an option; nothing for a flag.
std::string bash_action(const Argument& argument) {
  switch (kind_of(argument)) {
    case Kind::choice:
      return fmt::format("_vcrit_words \"$word\" '{}'; return", fmt::join(argument.choices, " "));
    case Kind::scene:
      return "_vcrit_files \"$word\" '!*.toml'; return";
    case Kind::folder:
      return "_vcrit_files \"$word\" '*'; return";
    case Kind::file:
      return "_vcrit_files \"$word\" ''; return";
    case Kind::text:
      return "return";
    case Kind::nothing:
      break;
  }
  return "";
}

std::string patterns(const Command& command, const Argument& argument) {
  std::vector<std::string> list;
  for (const std::string& name : argument.names)
    list.push_back(fmt::format("'{} {}'", command.name, name));
  return fmt::format("{}", fmt::join(list, " | "));
}

/// The value right behind an option, or a further one of a greedy option.
std::string value_cases(const std::vector<Command>& commands, bool further) {
  std::string out;
  for (const Command& command : commands)
    for (const Argument& argument : command.arguments) {
      const std::string what = bash_action(argument);
      if (argument.positional || what.empty()) continue;
      if (further && !(argument.greedy && kind_of(argument) == Kind::choice)) continue;
      // Behind a greedy option a scene may follow as well.
      const std::string done = further ? what.substr(0, what.rfind(';')) : what;
      out += fmt::format("    {}) {} ;;\n", patterns(command, argument), done);
    }
  return out;
}

std::string option_case(const Command& command, const std::string& commands) {
  std::vector<std::string> names;
  for (const Argument& argument : command.arguments)
    if (!argument.positional)
      names.insert(names.end(), argument.names.begin(), argument.names.end());
  if (command.name.empty())
    return fmt::format("    '') _vcrit_words \"$word\" '{} {}'; return ;;\n", commands,
                       fmt::join(names, " "));
  return fmt::format("    {}) [[ $word != -* ]] || _vcrit_words \"$word\" '{}' ;;\n", command.name,
                     fmt::join(names, " "));
}

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands)
    if (!command.name.empty()) names.push_back(command.name);
  return names;
}

}  // namespace

std::string bash_completion(const std::vector<Command>& commands) {
  const std::vector<std::string> names = names_of(commands);
  std::string out = bash_head;
  out.replace(out.find("COMMANDS"), 8, fmt::format("{}", fmt::join(names, " | ")));
  out += value_cases(commands, false) + bash_middle + value_cases(commands, true) + bash_options;
  for (const Command& command : commands)
    out += option_case(command, fmt::format("{}", fmt::join(names, " ")));
  return out + bash_tail;
}

}  // namespace vcrit::app
