// Texts from scenes before they are shown: what steers a terminal or misleads a reader made
// visible.
#pragma once

#include <string>
#include <string_view>

namespace vcrit {

/// The byte at `i`; 0 beyond the end.
unsigned byte_at(std::string_view text, std::size_t i);

/// The bytes at the beginning of `text` that make up one character that is not shown but steers:
/// a control character (newline and tabulator among them), an end of line in Unicode, or a mark
/// that turns the direction of writing. 0 if the first character is another one.
std::size_t steering(std::string_view text);

/// `text` (UTF-8) with such characters as "\u{1b}"; newlines and tabulators stay.
std::string without_steering(std::string_view text);

/// The same on one line: newlines and tabulators are spaces.
std::string one_line(std::string_view text);

}  // namespace vcrit
