// The two ends of Fig. 4: the largest amplitude without loss of contact, and friction at vanishing
// speed.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

AmplitudeLimits find_amplitude_limits();

StaticLimit approach_rest();

}  // namespace vcrit::validation::paper
