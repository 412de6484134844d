// What every page is: one HTML file that needs nothing else and lets nothing but its own scripts
// run.
#pragma once

#include <string>
#include <vector>

namespace vcrit::validation::report {

struct Document {
  std::string title;                 ///< as text
  std::string body;                  ///< as HTML
  bool charts = false;               ///< brings the scripts that draw them
  std::vector<std::string> scripts;  ///< further ones, which run after them
};

/// The whole file, with a content security policy that names each script by its hash.
std::string document(const Document& content);

/// SHA-256 of a script as a policy names it: "sha256-...".
std::string script_hash(std::string_view text);

}  // namespace vcrit::validation::report
