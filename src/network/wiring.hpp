// Networks made by hand: whether they are any, and whether their numbers have values.
#pragma once

#include "network/network.hpp"

namespace vcrit {

/// Throws InputError for a combination without parts, and for a graph without two terminals or
/// whose wires do not lead, one for each part, from one of its nodes to another.
void check_wiring(const Network& network);

/// The same of the graph alone, apart from its parts; here a wire may lead from a node to itself.
void check_wires(const Graph& graph);

/// Throws InputError for a symbol without a value.
double value_of(const Values& values, const Symbol& symbol);

}  // namespace vcrit
