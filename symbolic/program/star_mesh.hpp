// The stiffness of a graph by star-mesh elimination, with an error bound carried along.
#pragma once

#include <functional>

#include "network/network.hpp"
#include "program/complex.hpp"

namespace vcrit::symbolic {

struct MeshedStiffness {
  Complex k;
  NodeId roundings;  ///< a bound
};

/// `element` gives an element's stiffness as T/Q with Q = 1 or, Maxwell branch, 1 + i x.
MeshedStiffness by_star_mesh(
    Program& program, const Network& network,
    const std::function<std::pair<Complex, Complex>(const Element&)>& element);

}  // namespace vcrit::symbolic
