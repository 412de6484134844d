// Who made a report, and how to make it again.
#pragma once

#include <string>

#include "run/machine.hpp"

namespace vcrit::validation::report {

struct Origin {
  Machine machine;
  std::string command;
};

}  // namespace vcrit::validation::report
