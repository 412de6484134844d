// The end of every page: the command that makes it again, and on what it was made.
#pragma once

#include <string>

#include "machine.hpp"

namespace vcrit::validation::report {

/// Who made a report, and how to make it again.
struct Origin {
  Machine machine;
  std::string command;
};

std::string machine_section(const Origin& origin);

}  // namespace vcrit::validation::report
