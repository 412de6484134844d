// What of a graph is series and parallel.
#pragma once

#include "network/network.hpp"

namespace vcrit::symbolic::shortest {

/// The same network: edges side by side and one behind the other joined, as far as that goes, and
/// those from terminal to terminal beside the rest.
Network series_parallel(const Graph& graph);

}  // namespace vcrit::symbolic::shortest
