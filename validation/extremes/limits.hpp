// Numbers that vanish or grow without end: v* must come near the limit, as fast as Eq. 24 says.
#pragma once

#include <vector>

#include "compare/scene_report.hpp"
#include "extremes/families.hpp"
#include "extremes/regions.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation::extremes {

/// How far v* may be from the limit of `approach` at these values, relatively. Needs a scene with a
/// drive.
double distance_allowed(const Problem& problem, const Approach& approach, const Values& values);

/// For each approach of the family: the limit by computer algebra against v* of the remaining
/// scene, and `found` (v* in the cells, m/s) against that limit. `what`: who found it.
std::vector<Comparison> compare_limits(const Family& family, const symbolic::Derivation& derivation,
                                       const CellsOf& made, const std::vector<double>& found,
                                       const std::string& what);

}  // namespace vcrit::validation::extremes
