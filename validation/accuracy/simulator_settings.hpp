// The simulation methods, each at several settings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation::accuracy {

/// One method at one setting.
struct Setting {
  std::string method, name;
  double allowed = 0;      ///< error of mu_macro/mu0 above which the answer is wrong
  bool idealised = false;  ///< other physics: need not stick where the reference does
  std::function<simulation::SteadyState(const simulation::System&, double velocity)> solve;
};

/// The exact method first, then those others that can treat the system, each from coarse to fine.
/// Every solve ends after some 10^5 steps of its integrator, or fewer dear ones (system_size.hpp).
std::vector<Setting> all_settings(const simulation::System& system);

}  // namespace vcrit::validation::accuracy
