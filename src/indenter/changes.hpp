// Where the friction of a cell is no smooth function of its place.
#pragma once

#include <vector>

#include "indenter/half_space.hpp"

namespace vcrit::indenter {

/// Points (m) from 0 to the edge, increasing: both ends, the mean radius of contact, where cells
/// begin to part, where the slope of a table changes, and where the course of motion changes
/// otherwise, to 1e-12 of the edge. A course that comes and goes between two samples, of which
/// there are 25 from one of the former points to the next, is missed.
std::vector<double> changes(const HalfSpace& half_space, double velocity);

}  // namespace vcrit::indenter
