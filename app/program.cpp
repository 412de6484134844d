#include "program.hpp"

#include <fmt/core.h>
#include <unistd.h>
#include <CLI/CLI.hpp>  // with code of help and configuration, which a compiler takes seconds for:
                        // other files leave it at CLI/App.hpp

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/arguments.hpp"
#include "base/errors.hpp"
#include "base/plain_text.hpp"
#include "record/fields.hpp"
#include "record/json_text.hpp"
#include "streams.hpp"
#include "usage.hpp"

namespace vcrit::record {

void fields(Fields& f, const Place& it) {
  f("file", it.file).when(it.line > 0, "line", it.line);
  f.when(it.line > 0 && it.column > 0, "column", it.column);
}

}  // namespace vcrit::record

namespace vcrit::app {

namespace {

enum Status { done = 0, input_wrong = 2, outside_the_model = 3, bug = 70 };

/// What went wrong, in parts where they are known: null where they are not.
struct Failure {
  Status status;
  std::string message;
  std::optional<InputError> input = {};
  std::string advice = {};
  std::vector<std::string> warnings = {};

  friend void fields(record::Fields& f, const Failure& it) {
    f("status", int{it.status})("message", it.message);
    if (it.input)
      f("place", it.input->place())("found", it.input->found())("expected", it.input->expected());
    else
      f("place", nullptr)("found", nullptr)("expected", nullptr);
    f("advice", it.advice.empty() ? std::nullopt : std::optional(it.advice));
    f.some("warnings", it.warnings);
  }
};

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

/// What a library says of arguments, said of options.
InputError of_options(const InputError& error) {
  const InputError words = spelled(error, option_of);
  Place place = words.place();
  if (!place.argument.empty()) place = {place.argument};
  return {place, words.found(), words.expected(), words.advice()};
}

/// With json: one object on one line.
int complain(Failure failure, bool json) {
  if (!json) {
    const std::string line = without_steering(fmt::format("vcrit: {}", failure.message));
    tell("{}\n", alarming(line, STDERR_FILENO));
    return failure.status;
  }
  failure.warnings = kept_warnings();
  tell_line(record::json_text_in_ascii(record::json_of(failure)));
  return failure.status;
}

/// At any place of the command line, so that errors in the command line are told as JSON, too.
bool asks_for_json(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc,
                     [](const char* word) { return std::string_view(word) == "--json"; });
}

/// "vcrit" alone and "vcrit help COMMAND" ask for help, too.
std::vector<std::string> typed_words(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return {"--help"};
  if (words.front() != "help") return words;
  words.erase(words.begin());
  words.resize(std::min<std::size_t>(words.size(), 1));
  words.emplace_back("--help");
  return words;
}

int run_command(int argc, char** argv, const AddCommands& add, bool json) {
  const std::vector<std::string> words = typed_words(argc, argv);
  CLI::App program{
      "Vibration lowers sliding friction up to a critical velocity v*: its value, its formula, and "
      "the motion below it.",
      "vcrit"};
  program.require_subcommand(1);
  int status = done;
  add(program, status);
  refuse_no_values(program);
  try {
    std::vector<std::string> last_first(words.rbegin(), words.rend());
    program.parse(last_first);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0 || is_unknown_command(program, words.front())) {
      const InputError parts = in_parts(error, program, words.front());
      return complain({input_wrong, parts.what(), parts, parts.advice()}, json);
    }
    // CLI11 would print to std::cout, which forgets why it failed.
    std::ostringstream text;
    program.exit(error, text, text);
    fmt::print("{}", text.str());
  }
  finish_stdout();
  return status;
}

}  // namespace

std::string with_options(const std::string& text) { return spelled(text, option_of); }

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
    return complain({input_wrong, words.what(), words, words.advice()}, json);
  } catch (const Refused& error) {
    return complain({input_wrong, error.what()}, json);
  } catch (const ModelError& error) {
    const ModelError words = spelled(error, option_of);
    return complain({outside_the_model, words.what(), {}, words.advice()}, json);
  } catch (const std::system_error& error) {
    const InputError words = in_words(error);
    return complain({input_wrong, words.what(), words, words.advice()}, json);
  } catch (const std::bad_alloc&) {
    return complain({input_wrong, "out of memory (limit set by ulimit or the machine)"}, json);
  } catch (const std::exception& error) {
    return complain({bug, error.what()}, json);
  }
}

}  // namespace vcrit::app
