// Commands and their options as plain data, read from what CLI11 was told: help, man page and
// completions are written from it, so that none of them can know more or less than the program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace vcrit::app {

struct Argument {
  std::vector<std::string> names;    ///< "-h", "--help"; of a positional its one name, "SCENE"
  std::string value;                 ///< "DIR"; empty for a flag
  std::vector<std::string> choices;  ///< the only values, if there are any
  std::string preset;                ///< value without the option, as text; may be empty
  std::string words;
  bool positional = false, required = false;
  bool repeated = false;  ///< may be given several times
  bool greedy = false;    ///< one may be followed by several values
};

struct Command {
  std::string name;  ///< empty: the program without a command
  std::string words;
  std::string examples;             ///< as shown below the help
  std::vector<Argument> arguments;  ///< those of option groups, too
};

Argument argument_of(const CLI::Option& option);

/// The program itself, then its commands.
std::vector<Command> commands_of(const CLI::App& program);

/// "NAME=VALUE", "{text,latex}=text", "DIR, required": what follows an option's names in a help.
std::string value_words(const Argument& argument);

/// What a value of the argument is, for completion.
enum class Kind { nothing, choice, scene, folder, file, text };
Kind kind_of(const Argument& argument);

}  // namespace vcrit::app
