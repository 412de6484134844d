// Families of networks by size, and any network as nodes and elements.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "network/network.hpp"

namespace vcrit::scaling {

struct ScalingCase {
  std::string name;  ///< "ladder-20"
  Network network;
};

/// Springs in line and dampers to ground by turns.
ScalingCase ladder(int elements);
/// A spring beside Maxwell branches.
ScalingCase prony(int branches);
ScalingCase bridge();
/// Springs and dampers by turns on the edges of n x n nodes, from corner to corner.
ScalingCase grid(int n);

/// A network's elements between its nodes 0 and 1, the terminals, and inner nodes.
struct Wiring {
  struct Edge {
    std::size_t from, to;
    std::string stiffness;  ///< "k1", "c1*s"
  };
  std::size_t nodes = 2;
  std::vector<Edge> edges;
};
Wiring wiring(const Network& network);

}  // namespace vcrit::scaling
