// What the program says about itself to the shell: help, man page, completions, all from what CLI11
// was told, so that none of them can know more or less than the program.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace vcrit::app {

/// Adds --man and --completion, and examples and words to every help; to be called when all
/// commands are there.
void add_shell(CLI::App& program);

/// What may stand in place of the last of the words that follow the program's name, one a line,
/// with a tabulator before what it means; or ":" and a pattern of files, of folders "/". Words may
/// be parted at "=", as bash does.
std::string completions(const CLI::App& program, std::vector<std::string> words);

/// vcrit(1) as roff.
std::string man_page(const CLI::App& program);

/// Those of its groups, too; what has to be typed without a name comes first.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
/// "-h", "--help"; of a positional "SCENE".
std::vector<std::string> names_of(const CLI::Option& option);
/// The only values, if there are any.
std::vector<std::string> choices_of(const CLI::Option& option);
bool is_repeated(const CLI::Option& option);
/// "NAME=VALUE", "{text,latex}=text", "DIR, required": what follows an option's names in a help.
std::string value_words(const CLI::Option& option);

}  // namespace vcrit::app
