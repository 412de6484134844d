#include "program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "base/errors.hpp"
#include "streams.hpp"
#include "usage.hpp"

namespace vcrit::app {

namespace {

using nlohmann::ordered_json;

enum Status { done = 0, input_wrong = 2, outside_the_model = 3, bug = 70 };

/// What went wrong, in parts where they are known.
struct Failure {
  Status status;
  std::string message;
  const InputError* input = nullptr;
  std::string advice = {};
};

ordered_json place_of(const Place& place) {
  ordered_json parts{{"file", place.file}};
  if (place.line > 0) parts["line"] = place.line;
  if (place.line > 0 && place.column > 0) parts["column"] = place.column;
  return parts;
}

/// The option of an argument that a library names: "--friction-ratio", "--set k_1", "--from, --to".
std::string option_of(const std::string& argument) {
  std::string option = "--";
  bool of_name = true;  // a value may follow
  for (std::size_t i = 0; i < argument.size(); ++i) {
    of_name = of_name && argument[i] != ' ';
    option += of_name && argument[i] == '_' ? '-' : argument[i];
    if (of_name && argument.substr(i, 2) == ", ") option += " --", ++i;
  }
  return option;
}

/// What a library says of an argument, of the option.
InputError of_options(const InputError& error) {
  Place place = error.place();
  if (!place.argument.empty()) place = {option_of(place.argument)};
  return {place, error.found(), error.expected(), error.advice()};
}

/// One object on one line, with null for what is not known.
std::string in_json(const Failure& failure) {
  const auto known = [](const std::string& text) {
    return text.empty() ? ordered_json() : ordered_json(text);
  };
  ordered_json object{{"status", failure.status}, {"message", failure.message},
                      {"place", nullptr},         {"found", nullptr},
                      {"expected", nullptr},      {"advice", known(failure.advice)}};
  if (failure.input != nullptr) {
    object["place"] = place_of(failure.input->place());
    object["found"] = failure.input->found();
    object["expected"] = failure.input->expected();
  }
  if (const auto warnings = kept_warnings(); !warnings.empty()) object["warnings"] = warnings;
  return object.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
}

int complain(const Failure& failure, bool json) {
  if (json)
    tell_line(in_json(failure));
  else
    tell_line(fmt::format("vcrit: {}", failure.message));
  return failure.status;
}

/// Wherever it stands: what cannot be read is told in the same way.
bool asks_for_json(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc,
                     [](const char* word) { return std::string_view(word) == "--json"; });
}

int run_command(int argc, char** argv, const AddCommands& add, bool json) {
  CLI::App program{"Up to which sliding velocity can normal oscillation reduce friction?", "vcrit"};
  program.require_subcommand(1);
  int status = done;
  add(program, status);
  refuse_options_as_values(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (json && error.get_exit_code() != 0) {
      const InputError parts = in_parts(error);
      return complain({input_wrong, error.what(), &parts, parts.advice()}, json);
    }
    status = program.exit(error) == 0 ? done : input_wrong;
  }
  finish_stdout();
  return status;
}

}  // namespace

int run_program(int argc, char** argv, const AddCommands& add) {
  open_missing_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told as a full disk is
  const bool json = asks_for_json(argc, argv);
  if (json) keep_warnings();
  try {
    const int status = run_command(argc, argv, add, json);
    for (const std::string& warning : kept_warnings()) warn(warning);
    return status;
  } catch (const InputError& error) {
    const InputError words = of_options(error);
    return complain({input_wrong, words.what(), &words, words.advice()}, json);
  } catch (const Refused& error) {
    return complain({input_wrong, error.what()}, json);
  } catch (const ModelError& error) {
    return complain({outside_the_model, error.what(), nullptr, error.advice()}, json);
  } catch (const std::system_error& error) {
    const InputError words = in_words(error);
    return complain({input_wrong, words.what(), &words, words.advice()}, json);
  } catch (const std::bad_alloc&) {
    return complain({input_wrong, "the memory that it may use does not suffice"}, json);
  } catch (const std::exception& error) {
    return complain({bug, error.what()}, json);
  }
}

}  // namespace vcrit::app
