// Dotted keys of a TOML text, counted before it is parsed: toml++ takes tables apart recursively,
// so that a.a.a... would overflow the stack, and looks for each dotted key among all before it.
#pragma once

#include <string>

#include "base/errors.hpp"

namespace vcrit::document {

constexpr int most_key_parts = 20;       ///< a.b.c has three
constexpr int most_dotted_keys = 10000;  ///< headers as [networks.bridge] among them

/// Throws InputError, with line, for a text that has more of either.
void check_keys(const std::string& text, const std::string& file);

}  // namespace vcrit::document
