// What every page is: one HTML file that needs nothing else and lets nothing but its own scripts
// run, made of a record and the templates.
#pragma once

#include <string>
#include <vector>

#include "record/fields.hpp"

namespace vcrit::validation::report {

struct Document {
  std::string title;
  bool charts = false;               ///< brings the scripts that draw them
  std::vector<std::string> scripts;  ///< further ones, which run after them
  bool simulates = false;            ///< runs the simulator, which is WebAssembly
};

/// The whole file by the template of that name, with a content security policy that names each
/// script by its hash.
std::string document(const char* name, record::Json record, const Document& about);

/// A part of a page by the template of that name.
std::string rendered(const char* name, const record::Json& record);

/// SHA-256 of a script as a policy names it: "sha256-...".
std::string script_hash(std::string_view text);

}  // namespace vcrit::validation::report
