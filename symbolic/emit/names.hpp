// Names in generated code.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// Throws InputError unless `name` can be the namespace of a generated library and part of its
/// files' names.
void check_library_name(const std::string& name);

/// Throws InputError if a member of Parameters cannot have the name of one of these symbols.
void check_member_names(const Problem& problem, const std::vector<Symbol>& symbols);

}  // namespace vcrit::symbolic
