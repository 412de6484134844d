// Friction over the speed: each search begins at the steady cycle of the speed before.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

struct CurvePoint {
  std::optional<SteadyState> state;
  std::string reason;  ///< why there is none
};

/// One point for each velocity of the drive (m/s, > 0), in their order, which may be any. A point
/// outside the model does not stop the others; nothing is thrown for it.
std::vector<CurvePoint> friction_curve(const System& system, std::span<const double> velocities);

}  // namespace vcrit::simulation
