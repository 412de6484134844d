#include "usage.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
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

/// With those of its groups, which have no name.
std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const CLI::App* group :
       command.get_subcommands([](const CLI::App* each) { return each->get_name().empty(); }))
    for (const std::string& name : long_options(*group))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::string did_you_mean(const std::string& name) { return fmt::format("did you mean {}?", name); }

std::string meant(const std::string& word, const std::vector<std::string>& names) {
  const auto found = nearest(word, names);
  return found ? did_you_mean(*found) : advice;
}

/// Also one that is begun alike: evaluate, simulation.
std::string meant_command(const std::string& word, const std::vector<std::string>& names) {
  constexpr std::size_t alike = 4;
  for (const std::string& name : names)
    if (word.size() >= alike && name.substr(0, alike) == word.substr(0, alike))
      return did_you_mean(name);
  return meant(word, names);
}

/// The command that the line begins with, or the program itself.
const CLI::App& asked_of(const CLI::App& program, const std::string& first) {
  for (const CLI::App* command : commands_of(program))
    if (command->get_name() == first) return *command;
  return program;
}

std::string word_of_option(const std::string& word) { return word.substr(0, word.find('=')); }

bool names_option(const std::string& word) { return word.starts_with('-') && word != "-"; }

/// The first option that the line has too many, or else its first word.
std::string too_many(const std::vector<std::string>& rest) {
  const auto option = std::find_if(rest.begin(), rest.end(), names_option);
  return option == rest.end() ? rest.front() : *option;
}

/// "one SCENE", where a command has room for one.
std::string room_for(const CLI::App& command) {
  const auto positional = command.get_options([](const CLI::Option* option) {
    return option->get_positional() && option->get_items_expected_max() == 1;
  });
  return positional.size() == 1 ? "one " + positional.front()->get_name(true)
                                : "the arguments that --help lists";
}

/// A unit behind a blank, or another scene.
std::string advice_on_rest(const std::string& word) {
  return word.ends_with(".toml") ? advice : "a value with a blank in it needs quotes: \"2 mm/s\"";
}

bool takes_settings(const std::vector<std::string>& options) {
  return std::find(options.begin(), options.end(), "--set") != options.end();
}

/// What scenes hold and people take for an option.
bool is_quantity(const std::string& word) {
  constexpr std::array quantities{"--frequency", "--amplitude", "--indentation", "--coefficient",
                                  "--poisson",   "--mass",      "--force"};
  return std::find(quantities.begin(), quantities.end(), word_of_option(word)) != quantities.end();
}

std::string set_advice(const std::string& word) {
  return fmt::format("a number of the scene is --set {}=VALUE", word_of_option(word).substr(2));
}

InputError not_expected(const CLI::App& program, const std::string& first) {
  const CLI::App& command = asked_of(program, first);
  const std::string word = too_many(program.remaining(true));
  if (!names_option(word)) return {{whole_line}, word, room_for(command), advice_on_rest(word)};
  const std::vector<std::string> options = long_options(command);
  if (std::find(options.begin(), options.end(), word_of_option(word)) != options.end())
    return {{whole_line}, word + " behind --", "options before it", advice};
  if (const auto found = nearest(word_of_option(word), options))
    return {{whole_line}, word, "the arguments that --help lists", did_you_mean(*found)};
  return {{whole_line},
          word,
          fmt::format("one of {}", joined(options, ", ")),
          takes_settings(options) && is_quantity(word) ? set_advice(word) : advice};
}

/// An option before any command: one of the program, or one that belongs behind its command.
InputError option_first(const CLI::App& program, const std::string& first) {
  const std::string word = word_of_option(first);
  const auto own = nearest(word, long_options(program));
  if (own) return {{whole_line}, first, "a command", did_you_mean(*own)};
  return {{whole_line}, first, "a command before its options", "vcrit COMMAND --help lists them"};
}

/// "SCENE", or "--for {amplitude,frequency}".
std::string as_typed(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true);
  const std::string type = option.get_type_name();
  return option.get_name() + " " + after(type, "TEXT:").value_or(type);
}

/// All that a command still needs, at once: `first_of_them`, unless the command says more.
InputError what_is_missing(const CLI::App& command, const std::string& first_of_them) {
  std::vector<std::string> names, line;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required()) continue;
    line.push_back(as_typed(*option));
    if (option->count() == 0)
      names.push_back(option->get_positional() ? option->get_name(true) : option->get_name());
  }
  if (names.empty()) names = line = {first_of_them};
  return {{whole_line},
          fmt::format("no {}", joined(names, ", no ")),
          fmt::format("vcrit {} {}", command.get_name(), joined(line, " ")),
          advice};
}

/// "Exactly 1 option from [--velocity,--velocity-ratio] is required and 2 were given".
std::optional<InputError> choice_between(const std::string& text) {
  const std::size_t open = text.find("from ["), close = text.find("] is required");
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  std::string options = text.substr(open + 6, close - open - 6);
  if (const std::size_t comma = options.rfind(','); comma != std::string::npos)
    options.replace(comma, 1, " and ");
  const bool none = text.find(" were given") == std::string::npos;
  return InputError({whole_line}, none ? "none of " + options : options, "one of the two", advice);
}

/// "--limits excludes --material"
std::optional<InputError> excluded(const std::string& text) {
  const std::string between = " excludes ";
  const std::size_t at = text.find(between);
  if (at == std::string::npos) return std::nullopt;
  return InputError({whole_line}, text.substr(0, at) + " and " + text.substr(at + between.size()),
                    "one of the two", advice);
}

/// "{amplitude,force}": the words in it.
std::vector<std::string> words_of_set(const std::string& set) {
  std::vector<std::string> words;
  const std::size_t open = set.find('{'), close = set.find('}');
  if (open == std::string::npos || close == std::string::npos) return words;
  for (std::size_t begin = open + 1; begin < close;) {
    const std::size_t end = std::min(set.find(',', begin), close);
    words.push_back(set.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Says why, or nothing.
std::string what_is_no_value(const std::string& value) {
  if (value.empty()) return "found \"\"; expected a value";
  const bool option = value.size() > 2 && value.starts_with("--") &&
                      std::isalpha(static_cast<unsigned char>(value[2])) != 0;
  return option ? fmt::format("found {0}; expected a value (./{0} for a file so called)", value)
                : "";
}

}  // namespace

void refuse_no_values(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands({})) {
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0) option->check(what_is_no_value);
    refuse_no_values(*command);  // its groups
  }
}

bool is_unknown_command(const CLI::App& program, const std::string& first) {
  const std::vector<std::string> commands = command_names(commands_of(program));
  return !first.starts_with('-') && std::count(commands.begin(), commands.end(), first) == 0;
}

/// What an option's value is a number of: an int of C++ has neither fractions nor exponents.
std::string number_of(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr || option->get_type_name() != "INT") return "a number";
  return fmt::format("a whole number of at most {}", std::numeric_limits<int>::max());
}

InputError in_parts(const CLI::ParseError& error, const CLI::App& program,
                    const std::string& first) {
  const std::vector<std::string> commands = command_names(commands_of(program));
  if (is_unknown_command(program, first))
    return {{whole_line},
            fmt::format("\"{}\"", printable(first)),
            fmt::format("a command: {}", joined(commands, ", ")),
            first.ends_with(".toml") ? fmt::format("vcrit eval {}", printable(first))
                                     : meant_command(first, commands)};
  const std::string text = error.what();
  const bool lacks = text.ends_with(" is required"), too_much = !program.remaining(true).empty();
  if (first.starts_with('-') && (lacks || too_much)) return option_first(program, first);
  if (too_much) return not_expected(program, first);
  if (const auto chosen = choice_between(text)) return *chosen;
  if (const auto chosen = excluded(text)) return *chosen;
  if (lacks)
    return what_is_missing(asked_of(program, first), text.substr(0, text.find(" is required")));
  if (const auto rest = after(text, "Could not convert: "))
    if (const std::size_t sign = rest->find(" = "); sign != std::string::npos)
      return {{rest->substr(0, sign)},
              rest->substr(sign + 3),
              number_of(asked_of(program, first), rest->substr(0, sign)),
              advice};
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos)
    return {{whole_line}, text, "a command line as --help shows it", advice};
  std::string found = text.substr(colon + 2), expected = "a value as --help shows it";
  if (found.find(" required ") != std::string::npos && found.ends_with(" missing"))
    found = "no value";
  constexpr std::string_view received = " required but received ";
  if (const std::size_t at = found.find(received); at != std::string::npos)
    return {{text.substr(0, colon)},
            fmt::format("it {} times", found.substr(at + received.size())),
            "it once",
            advice};
  for (const auto& [between, such] :
       {std::pair{"; expected ", ""}, std::pair{" not in range ", "a number in the range "},
        std::pair{" not in ", "one of "}})
    if (const std::size_t bound = found.find(between); bound != std::string::npos) {
      expected = such + found.substr(bound + std::strlen(between));
      found.erase(bound);
    }
  for (const char* word : {"Value ", "found "})
    if (const auto value = after(found, word)) found = *value;
  if (found.empty()) found = "\"\"";
  return {{text.substr(0, colon)}, found, expected, meant(found, words_of_set(expected))};
}

}  // namespace vcrit::app
