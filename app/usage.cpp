#include "usage.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/identifiers.hpp"
#include "base/messages.hpp"

namespace vcrit::app {

namespace {

constexpr const char* const whole_line = "command line";
constexpr const char* const advice = "run with --help for more";

/// `text` without `begin`, or nothing where it begins otherwise.
std::optional<std::string> after(const std::string& text, const std::string& begin) {
  if (!text.starts_with(begin)) return std::nullopt;
  return text.substr(begin.size());
}

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> command_names(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string meant(const std::string& word, const std::vector<std::string>& names) {
  const auto found = nearest(word, names);
  return found ? fmt::format("did you mean {}?", *found) : advice;
}

InputError not_expected(const std::string& rest, const CLI::App& program,
                        const std::string& first) {
  std::vector<std::string> options = long_options(program);
  for (const CLI::App* command : commands_of(program))
    if (command->get_name() == first) options = long_options(*command);
  const std::string word = rest.substr(0, rest.find_first_of(" ="));
  return {{whole_line}, rest, "the arguments that --help lists", meant(word, options)};
}

}  // namespace

void refuse_options_as_values(CLI::App& program) {
  const auto refuse = [](const std::string& value) {
    const bool option = value.size() > 2 && value.starts_with("--") &&
                        std::isalpha(static_cast<unsigned char>(value[2])) != 0;
    return option ? fmt::format("found {0}; expected a value (./{0} for a file so called)", value)
                  : std::string();
  };
  for (CLI::App* command : program.get_subcommands({}))
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0) option->check(refuse);
}

bool is_unknown_command(const CLI::App& program, const std::string& first) {
  const std::vector<std::string> commands = command_names(commands_of(program));
  return !first.starts_with('-') && std::count(commands.begin(), commands.end(), first) == 0;
}

InputError in_parts(const CLI::ParseError& error, const CLI::App& program,
                    const std::string& first) {
  const std::vector<std::string> commands = command_names(commands_of(program));
  if (is_unknown_command(program, first))
    return {{whole_line},
            fmt::format("\"{}\"", printable(first)),
            fmt::format("a command: {}", fmt::join(commands, ", ")),
            meant(first, commands)};
  const std::string text = error.what();
  for (const char* begin :
       {"The following argument was not expected: ", "The following arguments were not expected: "})
    if (const auto rest = after(text, begin)) return not_expected(*rest, program, first);
  if (const std::size_t end = text.find(" is required"); end != std::string::npos)
    return {{whole_line},
            after(text.substr(end), " is required and ").value_or("none"),
            text.substr(0, end),
            advice};
  if (const auto rest = after(text, "Could not convert: "))
    if (const std::size_t sign = rest->find(" = "); sign != std::string::npos)
      return {{rest->substr(0, sign)}, rest->substr(sign + 3), "a number", advice};
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos)
    return {{whole_line}, text, "a command line as --help shows it", advice};
  std::string found = text.substr(colon + 2), expected = "a value as --help shows it";
  for (const auto& [between, such] :
       {std::pair{"; expected ", ""}, std::pair{" not in range ", "a number in the range "},
        std::pair{" not in ", "one of "}})
    if (const std::size_t bound = found.find(between); bound != std::string::npos) {
      expected = such + found.substr(bound + std::strlen(between));
      found.erase(bound);
    }
  for (const char* word : {"Value ", "found "})
    if (const auto value = after(found, word)) found = *value;
  return {{text.substr(0, colon)}, found, expected, advice};
}

}  // namespace vcrit::app
