// What the program says about itself to the shell: help, man page, completions.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "option_table.hpp"

namespace vcrit::app {

/// vcrit(1) as roff.
std::string man_page(const std::vector<Command>& commands);
/// To be sourced by bash.
std::string bash_completion(const std::vector<Command>& commands);
/// The function _vcrit, for a folder in zsh's fpath.
std::string zsh_completion(const std::vector<Command>& commands);

/// Adds --man and --completion, and examples and words to every help; to be called when all
/// commands are there.
void add_shell(CLI::App& program);

}  // namespace vcrit::app
