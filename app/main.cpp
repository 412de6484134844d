// The program `vcrit`.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include <string>
#include <string_view>

#include "commands.hpp"
#include "program.hpp"
#include "report/catalogue_page.hpp"
#include "report/material_page.hpp"
#include "run/machine.hpp"
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
  program.set_version_flag("--version", version_text, "print the versions of vcrit and its parts");
  static constexpr vcrit::app::DerivePages pages{vcrit::validation::report::catalogue_page,
                                                 vcrit::validation::report::material_page};
  vcrit::app::add_eval(program);
  vcrit::app::add_derive(program, status, &pages);
  vcrit::app::add_generate(program);
  vcrit::app::add_simulate(program);
  vcrit::app::add_critical(program, status);
  vcrit::app::add_plot(program);
  vcrit::app::add_explore(program);
  vcrit::app::add_sweep(program, argv);
  vcrit::app::add_solve(program);
  vcrit::app::add_fit(program);
  vcrit::app::add_new(program);
  vcrit::app::add_check(program, status);
  vcrit::app::add_validate(program, status);
  vcrit::app::add_shell(program);
}

/// vcrit --complete WORD...: what the shells' completions ask, in words that are no command line.
int complete(int argc, char** argv) {
  CLI::App program;
  int status = 0;
  add_commands(program, status, argv);
  fmt::print("{}", vcrit::app::completions(program, {argv + 2, argv + argc}));
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--complete") return complete(argc, argv);
  const auto add = [argv](CLI::App& program, int& status) { add_commands(program, status, argv); };
  return vcrit::app::run_program(argc, argv, add);
}
