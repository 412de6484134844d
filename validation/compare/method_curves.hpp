// Friction over speed by the methods beside the exact one.
#pragma once

#include <vector>

#include "compare/scene_report.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// Each method with its usual setting at some speeds below and just above `threshold` (m/s), and
/// how far it is from the exact method. Methods that know nothing of such systems are left out, and
/// of large ones those with dense matrices.
std::vector<MethodCurve> method_curves(const simulation::System& system, double threshold);

}  // namespace vcrit::validation
