// The critical velocity of any scene: by Eq. (24) where that holds, else by simulation. Where the
// surfaces part, the closed form holds on for two kinds of scenes:
//   - a path without mass, damper and branches: the contact velocity is v0 less the rate of the
//     friction bound over a stiffness, and the bound is steepest where the closed contact has it;
//   - an isotropic contact under a rigid drive: in sliding the tangential deformations are mu0
//     K_n/K_t times the normal ones, while touching and while apart, so that the contact velocity
//     is v0 - mu0 (K_n/K_t) du_z/dt whatever the network; as long as the surfaces touch where u_z
//     rises fastest, which a surface that creeps back too slowly does not.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace vcrit {

struct CriticalOnset {
  enum class By { formula, simulation };
  By by = By::formula;
  double contact_velocity = 0;  ///< v*, m/s
  double drive_velocity = 0;    ///< m/s; larger only where a network on the path creeps
  double relative_error_bound =
      0;               ///< of v*; of a simulated one NaN: no bound is known, only rounding is lost
  std::string reason;  ///< why v* is infinite, else empty
};

/// Throws InputError for missing values, ModelError where v* is 0/0 and outside the model.
CriticalOnset critical_onset(const Scene& scene);

}  // namespace vcrit
