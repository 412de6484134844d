// A program of commands: what its words do, and what each kind of error means for the exit status.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

namespace vcrit::app {

/// What the user or the system refused, in words of its own: exit status 2.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `text` of a library with the options of the arguments that it names (base/arguments.hpp).
std::string with_options(const std::string& text);

/// Adds the commands; they set the exit status where it is not 0.
using AddCommands = std::function<void(CLI::App& program, int& status)>;

/// Runs the command that the arguments name. Returns the exit status.
int run_program(int argc, char** argv, const AddCommands& add);

}  // namespace vcrit::app
