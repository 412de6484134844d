// Where the reduced model is off, and by how much, over delta and v0/v*.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

DifferenceMap map_difference();

}  // namespace vcrit::validation::paper
