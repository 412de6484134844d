// Which scenes the simulator can move: it knows one body, under a network of springs and dampers,
// none of them with a loss factor at one frequency. Asked by what simulates and by what says that it
// can be simulated.
#pragma once

#include "scene/scene.hpp"

namespace vcrit {

/// Why the drive is none that it can move; empty where it is.
std::string beyond_simulation(const Scene& scene);

}  // namespace vcrit
