// What every page carries with it: the style, the charting packages, the page's own script.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vcrit::validation::report {

struct Script {
  std::string name, version;
  std::string_view text;
};

/// In the order in which they must run.
const std::vector<Script>& scripts();

std::string_view style();

/// What moves the explorer; pages without one do not carry it.
std::string_view explorer_script();

}  // namespace vcrit::validation::report
