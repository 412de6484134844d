// Names from scenes end up in generated code: which of them are safe there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vcrit {

/// Why `name` cannot be a name in generated code ("is a keyword of C++", ...); nothing if it can.
std::optional<std::string> unsafe_as_identifier(std::string_view name);

/// Letters put in, left out or replaced that make one text the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate most like `name`, if one is close enough to be what was meant; for
/// no name longer than any can be.
std::optional<std::string> nearest(std::string_view name,
                                   const std::vector<std::string>& candidates);

}  // namespace vcrit
