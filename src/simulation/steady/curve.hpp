// Friction over the speed: each search begins at the steady cycle of the speed before.
#pragma once

#include <functional>
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

/// A point while it lasts: its state is found anew in the same memory for the next one.
struct PassingPoint {
  const SteadyState* state = nullptr;
  const char* reason = "";  ///< why there is none
};

/// The same without keeping the points: use(place, point) as each is found, from the fastest on.
void friction_curve(const System& system, std::span<const double> velocities,
                    const std::function<void(std::size_t, const PassingPoint&)>& use);

}  // namespace vcrit::simulation
