// The two ends of Fig. 4: the largest amplitude without jumping, and friction at vanishing speed.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

JumpLimits find_jump_limits();

StaticLimit approach_rest();

}  // namespace vcrit::validation::paper
