// The program `vcrit`.
#include <fmt/core.h>

#include <string>

#include "commands.hpp"
#include "machine.hpp"
#include "program.hpp"
#include "report/catalogue_page.hpp"
#include "shell.hpp"

namespace {

std::string version_text() {
  const vcrit::validation::Machine machine = vcrit::validation::this_machine();
  std::string text = fmt::format("vcrit {} (commit {})", machine.program, machine.commit);
  for (const auto& [name, version] : machine.versions)
    text += fmt::format("\n{} {}", name, version);
  return text;
}

void add_commands(CLI::App& program, int& status, char** argv) {
  vcrit::app::add_derive(program, status, vcrit::validation::report::catalogue_page);
  vcrit::app::add_eval(program);
  vcrit::app::add_generate(program);
  vcrit::app::add_simulate(program);
  vcrit::app::add_critical(program, status);
  vcrit::app::add_sweep(program, argv);
  vcrit::app::add_solve(program);
  vcrit::app::add_fit(program);
  vcrit::app::add_validate(program, status);
  vcrit::app::add_shell(program);
}

}  // namespace

int main(int argc, char** argv) {
  const auto add = [argv](CLI::App& program, int& status) { add_commands(program, status, argv); };
  return vcrit::app::run_program(argc, argv, add, version_text);
}
