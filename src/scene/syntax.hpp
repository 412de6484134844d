// Lines of a scene that are no TOML: what was meant, and what to put in their place where the rest
// is read on for its errors.
#pragma once

#include <optional>
#include <string>

#include "base/errors.hpp"

namespace vcrit::document {

/// The complaint of the line at `place`, whose parser says `description`: a value with a unit or a
/// text without quotes, a decimal comma; else that description.
InputError syntax_error(const std::string& text, const Place& place,
                        const std::string& description);

/// The text with a name in place of the value in that line, or with an empty line where that has
/// been tried (`again`); nothing where the line is no key with a value.
std::optional<std::string> without_line(const std::string& text, int line, bool again);

}  // namespace vcrit::document
