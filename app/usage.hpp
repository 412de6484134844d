// Command lines that cannot be read.
#pragma once

#include <CLI/CLI.hpp>

#include "base/errors.hpp"

namespace vcrit::app {

/// Refuses an option where a value belongs: "--out --json" is no folder of that name.
void refuse_options_as_values(CLI::App& program);

/// The sentence of an error in the parts of every other message.
InputError in_parts(const CLI::ParseError& error);

}  // namespace vcrit::app
