// Command lines that cannot be read.
#pragma once

#include <CLI/App.hpp>

#include "base/errors.hpp"

namespace vcrit::app {

/// Refuses an option where a value belongs ("--out --json" is no folder of that name), and an empty
/// one, which is an unset variable of the shell.
void refuse_no_values(CLI::App& program);

/// Whether the first word behind the program's name should be a command and is none.
bool is_unknown_command(const CLI::App& program, const std::string& first);

/// The sentence of an error in the parts of every other message, with the command or option that
/// was meant where one is like it. `first`: the first word behind the program's name.
InputError in_parts(const CLI::ParseError& error, const CLI::App& program,
                    const std::string& first);

}  // namespace vcrit::app
