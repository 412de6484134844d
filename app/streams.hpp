// The three standard streams: what is printed has arrived, or the program says that it has not.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/errors.hpp"

namespace vcrit::app {

/// Streams that were closed by the caller lead nowhere, so that no file of ours takes their number.
void open_missing_streams();

/// To stderr; that nobody can read it is no reason to stop.
void tell(std::string_view text);

template <class... T>
void tell(fmt::format_string<T...> format, T&&... arguments) {
  tell(std::string_view(fmt::format(format, std::forward<T>(arguments)...)));
}

/// The same as a line, with what would steer a terminal (control characters, marks that turn the
/// direction of writing) as \u{1b}: texts from scenes stand in messages.
void tell_line(std::string_view text);

/// Red where the stream is a terminal that shows colours and the user wants them (NO_COLOR, TERM):
/// for what is wrong, always with words that say so.
std::string alarming(const std::string& text, int stream);

/// A warning on stderr, or kept for an error that is told as one JSON object.
void warn(const std::string& warning);
void keep_warnings();
/// Those kept, which are then forgotten.
std::vector<std::string> kept_warnings();

/// Ends what was printed on stdout. Throws InputError where it could not be written.
void finish_stdout();

/// What the system refused: to write to stdout, or another thing that the error names.
InputError in_words(const std::system_error& error);

}  // namespace vcrit::app
