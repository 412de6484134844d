// The contact at rest: what carries its mean normal force.
#pragma once

#include <ginac/ginac.h>

#include <optional>

#include "formula/line.hpp"
#include "network/reduction.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// With what carries a load at rest in place of elements that have no law in s.
Reduction as_at_rest(Reduction reduction);

/// Whether K_n(0) > 0, whatever the values of the elements.
bool carries_load(const Problem& problem);

/// K_n(0), if it carries a load and is short enough to be read.
std::optional<GiNaC::ex> stiffness_at_rest(const Problem& problem);

/// "u_z0 = W/K_n(0)" of a closed contact under a load; nothing where the indentation is given, for
/// an indenter, and where K_n(0) is 0 or too long.
std::optional<Line> indentation_line(const Problem& problem);

}  // namespace vcrit::symbolic
