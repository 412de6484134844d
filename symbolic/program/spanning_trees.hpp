// The stiffness of a graph between nodes 0 and 1, as a quotient of sums over spanning trees.
#pragma once

#include <optional>
#include <vector>

#include "network/network.hpp"
#include "program/stiffness.hpp"

namespace vcrit::symbolic {

/// `parts` are the edges' stiffnesses, whose errors meet those of this step as any element's.
/// Nothing for a graph that needs too many trees.
std::optional<Stiffness> by_spanning_trees(Program& program, const Graph& graph,
                                           const std::vector<Stiffness>& parts, Zeros zeros);

}  // namespace vcrit::symbolic
