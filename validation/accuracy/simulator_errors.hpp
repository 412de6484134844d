// Steady states by every simulation method at several settings: error against run time.
#pragma once

#include <functional>

#include "accuracy/data.hpp"
#include "scene/scene.hpp"
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

/// The exact method first, then the others, each from coarse to fine. Every solve ends after some
/// 10^5 steps of its integrator.
std::vector<Setting> all_settings();

/// What the others are compared with.
struct FrictionReference {
  double friction_ratio = 0;
  bool sticks = false;
  std::string words;
  std::optional<double> agreement;  ///< as in SpeedSolves
};

/// Fills in error and failure of an answered solve.
void judge(Solve& solve, const Setting& setting, bool sticks, const FrictionReference& reference);

/// By seconds and error; those that failed are left aside.
void mark_front(std::vector<Solve>& solves);

/// At speeds of `ratios` times the lowest speed of pure sliding. Throws ModelError where the scene
/// cannot be simulated.
std::vector<SpeedSolves> simulator_errors(const Scene& scene, const std::vector<double>& ratios);

}  // namespace vcrit::validation::accuracy
