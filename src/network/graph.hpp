// Which edges of a graph carry load between its terminals, and networks with elements left out.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "network/network.hpp"

namespace vcrit {

struct LoadedGraph {
  Graph graph;  ///< only edges on a path between the terminals, only their nodes
  std::vector<std::size_t> left_out;  ///< indices of the edges that carry no load, in the old graph
};

/// Nothing if the terminals are not connected. Throws InputError for wires that lead to no nodes.
std::optional<LoadedGraph> load_carrying(Graph graph);

/// What an element becomes; nothing: an open gap.
using NewElement = std::function<std::optional<Element>(const Element&)>;

/// The network with each element replaced; nothing if no path is left. Throws as load_carrying().
std::optional<Network> with_elements(const Network& network, const NewElement& element_of);

/// The network with the elements for which `absent` holds taken out (each an open gap); nothing if
/// no path is left between the terminals.
std::optional<Network> without(const Network& network,
                               const std::function<bool(const Element&)>& absent);

/// What carries a load at rest: the network without dampers, Maxwell branches and masses.
std::optional<Network> springs_alone(const Network& network);

}  // namespace vcrit
