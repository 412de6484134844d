#include "program.hpp"

#include <fmt/core.h>

#include <csignal>
#include <exception>
#include <new>
#include <system_error>

#include "base/errors.hpp"
#include "streams.hpp"

namespace vcrit::app {

namespace {

enum Status { done = 0, input_wrong = 2, outside_the_model = 3, bug = 70 };

int complain(const std::exception& error, Status status) {
  tell_line(fmt::format("vcrit: {}", error.what()));
  return status;
}

int run_command(int argc, char** argv, const AddCommands& add,
                const std::function<std::string()>& version) {
  CLI::App program{"Up to which sliding velocity can normal oscillation reduce friction?", "vcrit"};
  program.require_subcommand(1);
  if (version)
    program.set_version_flag("--version", version, "print the versions of vcrit and its parts");
  int status = done;
  add(program, status);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    status = program.exit(error) == 0 ? done : input_wrong;
  }
  finish_stdout();
  return status;
}

}  // namespace

int run_program(int argc, char** argv, const AddCommands& add,
                const std::function<std::string()>& version) {
  open_missing_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told as a full disk is
  try {
    return run_command(argc, argv, add, version);
  } catch (const InputError& error) {
    return complain(error, input_wrong);
  } catch (const Refused& error) {
    return complain(error, input_wrong);
  } catch (const ModelError& error) {
    return complain(error, outside_the_model);
  } catch (const std::system_error& error) {
    return complain(in_words(error), input_wrong);
  } catch (const std::bad_alloc&) {
    return complain(std::runtime_error("the memory that it may use does not suffice"), input_wrong);
  } catch (const std::exception& error) {
    return complain(error, bug);
  }
}

}  // namespace vcrit::app
