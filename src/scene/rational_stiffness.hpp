// A stiffness typed in as a rational function of s: stiffness = "(12e6*s + 8e9)/(s + 1e3)".
#pragma once

#include <string>

#include "base/errors.hpp"
#include "network/foster.hpp"

namespace vcrit {

/// The springs and dampers that have the stiffness `text` of [networks.NAME]; `place` is where its
/// first character stands. In N/m, or Pa of a half-space, and rad/s. Throws InputError with the
/// column, also for what no springs and dampers have.
FosterForm read_stiffness(const std::string& text, const std::string& name, const Place& place);

}  // namespace vcrit
