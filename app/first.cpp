// `vcrit_first`: numbers and formulas alone, built while the rest of `vcrit` is not there yet
// (./dev demo).
#include "commands.hpp"
#include "program.hpp"

namespace {

void add_first_commands(CLI::App& program, int& status) {
  vcrit::app::add_derive(program, status, nullptr);
  vcrit::app::add_eval(program);
}

}  // namespace

int main(int argc, char** argv) { return vcrit::app::run_program(argc, argv, add_first_commands); }
