// Examples below the help of the program and of each command.
#pragma once

namespace CLI {
class App;
}

namespace vcrit::app {

/// To be called when all commands are there.
void add_examples(CLI::App& program);

}  // namespace vcrit::app
