// Names end up in programs, tables and computer algebra systems, and not all of these read letters
// beyond ASCII: such names are refused where they are read, with how to spell them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "base/errors.hpp"

namespace vcrit {

/// The name around the byte `at` of a text (UTF-8) where it holds letters beyond ASCII ("k_größe");
/// else empty.
std::string_view name_beyond_ascii(std::string_view text, std::size_t at);

/// The complaint of such a name at the byte `at` of a text that begins at `place`.
std::optional<InputError> complaint_beyond_ascii(std::string_view text, std::size_t at,
                                                 const Place& place);

/// Throws it, if there is one.
void refuse_name_beyond_ascii(std::string_view text, std::size_t at, const Place& place);

}  // namespace vcrit
