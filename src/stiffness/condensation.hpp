// What series and parallel leave of a graph: edges side by side become one, and so do edges in a
// row, whatever order and depth they stand in.
#pragma once

#include <cstddef>
#include <vector>

#include "stiffness/relaxation.hpp"

namespace vcrit {

/// Edges of these forms between numbered nodes; the terminals are nodes 0 and 1, every node is
/// connected with them and no edge dangles.
struct RelaxationGraph {
  std::size_t nodes = 2;
  std::vector<Wire> wires;
  std::vector<Relaxation> edges;
};

/// The same between its terminals: no two edges between the same nodes, and at least three at each
/// inner node. A graph that series and parallel reduce has one edge left.
RelaxationGraph condensed(const RelaxationGraph& graph);

}  // namespace vcrit
