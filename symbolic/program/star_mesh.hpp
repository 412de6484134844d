// The stiffness of a graph by star-mesh elimination, with an error bound carried along.
#pragma once

#include <functional>

#include "network/network.hpp"
#include "program/complex.hpp"

namespace vcrit::symbolic {

struct MeshedStiffness {
  ComplexNode k;
  NodeId roundings;  ///< a bound
};

/// An element's stiffness as T/Q with Q = 1 or, Maxwell branch, 1 + i x, and its error in
/// roundings.
struct MeshElement {
  ComplexNode t, q;
  int roundings = 0;
};

MeshedStiffness by_star_mesh(Program& program, const Network& network,
                             const std::function<MeshElement(const Element&)>& element);

}  // namespace vcrit::symbolic
