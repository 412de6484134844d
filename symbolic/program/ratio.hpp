// K_t/K_n of an isotropic contact in a Program.
#pragma once

#include "problem/problem.hpp"
#include "program/stiffness.hpp"

namespace vcrit::symbolic {

/// A parameter or a constant for each symbol.
using SymbolValue = std::function<NodeId(Program&, const Symbol&)>;

/// K_t/K_n = t/q, both real.
struct Ratio {
  NodeId t = 0, q = 0;
  int path = 0;  ///< roundings
  ExponentRange range, t_range, q_range;
};

Ratio contact_ratio(Program& program, StiffnessWriter& stiffness, const Isotropic& isotropic,
                    const SymbolValue& value);

}  // namespace vcrit::symbolic
