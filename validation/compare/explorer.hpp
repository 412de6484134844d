// What the page needs so that its reader can move the scene's parameters: the generated JavaScript
// evaluator for v*, and friction curves simulated beforehand.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "compare/scene_report.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// What the scene's symbols are called in the page's script: as in the program, which knows omega
/// by its name, but for elements whose name there no script can have.
std::map<std::string, std::string> names_in_page(const Problem& problem);

/// Nothing for drives that generated code does not know. Friction is left out where the scene is
/// not simulated, or large (system_size.hpp).
std::optional<Explorer> explorer(symbolic::Derivation derivation,
                                 const std::vector<ValueLine>& values);

}  // namespace vcrit::validation
