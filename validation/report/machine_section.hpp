// How a page was made: command, machine, versions.
#pragma once

#include <string>

#include "machine.hpp"

namespace vcrit::validation::report {

/// command: a line for a shell.
std::string machine_section(const Machine& machine, const std::string& command);

}  // namespace vcrit::validation::report
