#include "usage.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace vcrit::app {

namespace {

constexpr const char* const whole_line = "command line";
constexpr const char* const advice = "run with --help for more";

/// `text` without `begin`, or nothing where it begins otherwise.
std::optional<std::string> after(const std::string& text, const std::string& begin) {
  if (!text.starts_with(begin)) return std::nullopt;
  return text.substr(begin.size());
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

InputError in_parts(const CLI::ParseError& error) {
  const std::string text = error.what();
  for (const char* begin :
       {"The following argument was not expected: ", "The following arguments were not expected: "})
    if (const auto rest = after(text, begin))
      return {{whole_line}, *rest, "the arguments that --help lists", advice};
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
