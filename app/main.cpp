// The program `vcrit`: commands, and what each kind of error means for the exit status.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "base/errors.hpp"
#include "commands.hpp"
#include "machine.hpp"
#include "shell.hpp"
#include "streams.hpp"
#include "workers.hpp"

namespace {

enum Status { done = 0, input_wrong = 2, outside_the_model = 3, bug = 70 };

int complain(const std::exception& error, Status status) {
  vcrit::app::tell_line(fmt::format("vcrit: {}", error.what()));
  return status;
}

std::string version_text() {
  const vcrit::validation::Machine machine = vcrit::validation::this_machine();
  std::string text = fmt::format("vcrit {}", machine.program);
  for (const auto& [name, version] : machine.versions)
    text += fmt::format("\n{} {}", name, version);
  return text;
}

int run_program(int argc, char** argv) {
  CLI::App program{"Up to which sliding velocity can normal oscillation reduce friction?", "vcrit"};
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text, "print the versions of vcrit and its parts");
  int status = done;
  vcrit::app::add_derive(program, status);
  vcrit::app::add_eval(program);
  vcrit::app::add_generate(program);
  vcrit::app::add_simulate(program);
  vcrit::app::add_critical(program, status);
  vcrit::app::add_sweep(program);
  vcrit::app::add_solve(program);
  vcrit::app::add_fit(program);
  vcrit::app::add_validate(program, status);
  vcrit::app::add_shell(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    status = program.exit(error) == 0 ? done : input_wrong;
  }
  vcrit::app::finish_stdout();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  vcrit::app::open_missing_streams();
  try {
    return run_program(argc, argv);
  } catch (const vcrit::InputError& error) {
    return complain(error, input_wrong);
  } catch (const vcrit::validation::JobRefused& error) {
    return complain(error, input_wrong);
  } catch (const vcrit::ModelError& error) {
    return complain(error, outside_the_model);
  } catch (const std::system_error& error) {
    return complain(vcrit::app::in_words(error), input_wrong);
  } catch (const std::bad_alloc&) {
    return complain(std::runtime_error("the memory that it may use does not suffice"), input_wrong);
  } catch (const std::exception& error) {
    return complain(error, bug);
  }
}
