// Text of the user's own inside a message: on one screen, whatever its bytes are.
#pragma once

#include <string>
#include <string_view>

namespace vcrit {

/// A message says no more of a text than this.
constexpr std::size_t longest_in_message = 4000;

/// `text` with what steers (plain_text.hpp) and what is no UTF-8 as \xNN (a line break as \n), and
/// with its middle left out where it is longer than `longest_in_message` bytes.
std::string printable(std::string_view text);

}  // namespace vcrit
