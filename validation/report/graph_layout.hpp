// Where the nodes of a graph go: terminals at both ends of a line, inner nodes in columns by their
// distance from the first terminal.
#pragma once

#include <vector>

#include "network/network.hpp"

namespace vcrit::validation::report {

struct LayoutPoint {
  double x = 0, y = 0;
};

struct GraphLayout {
  std::vector<LayoutPoint> nodes;  ///< terminal 0 at (0, 0), terminal 1 at (width, 0)
  double width = 0;
  double reach = 0;  ///< largest |y|
};

/// Nodes that an edge joins are at least `spacing` apart.
GraphLayout lay_out(const Graph& graph, double spacing);

}  // namespace vcrit::validation::report
