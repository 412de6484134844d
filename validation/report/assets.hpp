// What every page carries with it: the style and the scripts.
#pragma once

#include <string_view>
#include <vector>

namespace vcrit::validation::report {

/// Of a page with charts, in the order in which they must run.
const std::vector<std::string_view>& scripts();

/// The first of them, which also makes formulas as small as a sheet of paper asks.
std::string_view page_script();

std::string_view style();

/// All of templates/, packed for record::Templates.
std::string_view templates();

/// What chooses a moment of a period, and what shows it in a scene's charts of one, which needs it.
std::string_view scrubber_script();
std::string_view cycle_script();

/// What moves the explorer, with the scrubber, in this order, and how it looks; pages without one
/// do not carry them.
const std::vector<std::string_view>& explorer_scripts();
std::string_view explorer_style();
/// The simulator as WebAssembly, by gzip.
std::string_view simulator();

/// What filters an index.
std::string_view index_script();

}  // namespace vcrit::validation::report
