// Which commands answer for a scene, what they leave out and why: what the rulebook says, by
// command.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "record/fields.hpp"

namespace vcrit::app {

struct CommandAnswer {
  std::string command;
  bool answers = true;
  std::string reason = {}, advice = {};    ///< why not; may be empty
  std::vector<std::string> left_out = {};  ///< what it goes on without
  friend void fields(record::Fields& f, const CommandAnswer& it) {
    f("command", it.command)("answers", it.answers)("reason", it.reason)("advice", it.advice);
    f("left_out", it.left_out);
  }
};

/// Of all that take a scene, in the order of the program's help.
std::vector<CommandAnswer> answering_commands(const Problem& problem);

}  // namespace vcrit::app
