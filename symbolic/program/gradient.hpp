// All partial derivatives of a program's result by one backward pass (reverse accumulation).
#pragma once

#include <map>

#include "program/velocity.hpp"

namespace vcrit::symbolic {

struct GradientProgram {
  Program program;
  NodeId ratio = 0;                   ///< above/below
  NodeId value = 0;                   ///< v*
  std::map<Symbol, NodeId> partials;  ///< d v*/d parameter, of kind exact or value
};

GradientProgram gradient_program(VelocityProgram velocity);

}  // namespace vcrit::symbolic
