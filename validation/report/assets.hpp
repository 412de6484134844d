// What every page carries with it: the style, the charting packages, the page's own script.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vcrit::validation::report {

struct Script {
  std::string name, version;
  std::string_view text;
  std::string hash;  ///< "sha256-...", as a content security policy names it
};

/// In the order in which they must run.
const std::vector<Script>& scripts();

std::string_view style();

/// Bytes given in hexadecimal, in base 64.
std::string base64_of_hex(std::string_view hex);

}  // namespace vcrit::validation::report
