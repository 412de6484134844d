// A problem as text that the module in a page reads: resolved and in SI units, so that the page
// needs neither TOML nor units. Reading gives the same structure and, to the bit, the same numbers.
#pragma once

#include <string>

#include "problem/problem.hpp"
#include "scene/scene.hpp"

namespace vcrit::live {

std::string scene_text(const Problem& problem);

/// The scene of such a text. It is trusted: nobody but scene_text writes one.
Scene scene_of(const std::string& text);

}  // namespace vcrit::live
