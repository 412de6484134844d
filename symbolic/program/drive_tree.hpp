// The stiffness of a drive that holds masses: series and parallel parts step by step, what is left
// of a graph as sums over its spanning trees.
#pragma once

#include "network/network.hpp"
#include "program/drive_pair.hpp"

namespace vcrit::symbolic {

/// Throws ModelError for a graph that needs too many spanning trees.
DrivePair drive_pair(Program& program, PairWriter& writer, const Network& network);

}  // namespace vcrit::symbolic
