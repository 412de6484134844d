// Names that one language refuses beyond those that no generated code can have.
#pragma once

#include <string>
#include <vector>

#include "emit/languages/languages.hpp"
#include "scene/scene.hpp"

namespace vcrit::symbolic {

/// Throws InputError unless `name` can be the prefix, module or namespace of a generated file.
void check_library_name(const std::string& name, Language language);

/// Throws InputError if a parameter cannot have the name of one of these symbols.
void check_member_names(const Scene& scene, const std::vector<Symbol>& symbols, Language language);

}  // namespace vcrit::symbolic
