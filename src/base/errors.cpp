#include "base/errors.hpp"

#include <fmt/core.h>

#include "base/messages.hpp"

namespace vcrit {

namespace {

std::string with_advice(const std::string& words, const std::string& advice) {
  return advice.empty() ? words : words + "; " + advice;
}

}  // namespace

Place argument(const std::string& name) { return {"", 0, 0, name}; }

std::string to_text(const Place& place) {
  if (!place.argument.empty()) return place.argument;
  std::string text = place.file;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  return text;
}

InputError::InputError(const Place& place, const std::string& found, const std::string& expected,
                       const std::string& advice)
    : std::runtime_error(
          with_advice(fmt::format("{}: found {}; expected {}", printable(to_text(place)),
                                  printable(found), printable(expected)),
                      printable(advice))),
      parts_(std::make_shared<const Parts>(Parts{place, found, expected, advice})) {}

ModelError::ModelError(const std::string& what, const std::string& advice)
    : std::runtime_error(with_advice(what, advice)),
      advice_(std::make_shared<const std::string>(advice)) {}

Bug::Bug(const std::string& what, const char* function)
    : std::logic_error(fmt::format("bug in vcrit ({}): {}", function, what)) {}

void ensure(bool holds, const char* what, const char* function) {
  if (!holds) throw Bug(what, function);
}

}  // namespace vcrit
