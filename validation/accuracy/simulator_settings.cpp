#include "accuracy/simulator_settings.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "compare/system_size.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::validation::accuracy {

namespace {

using simulation::Method;
using simulation::MethodOptions;
using simulation::System;

// Some 20 to 60 ms of an integrator.
constexpr int integrator_steps = 100'000;
// Errors of single steps add up over hundreds of them and some periods; more than so many times
// what was asked for has another cause.
constexpr double accumulation = 1e3;
// Wrong whatever was asked for.
constexpr double wrong_by_any_measure = 0.05;
Setting with(Method method, std::string name, double allowed, const MethodOptions& options) {
  return {to_text(method), std::move(name), std::min(allowed, wrong_by_any_measure), false,
          [=](const System& system, double velocity) {
            return simulation::steady_state(method, system, velocity, options);
          }};
}

Setting exact_setting() {
  // Its steady values are promised to 1e-9.
  return {"exact", "", 1e-9, false, [](const System& system, double velocity) {
            return simulation::steady_state(system, velocity);
          }};
}

MethodOptions limited(double share) {
  MethodOptions options;
  options.most_steps = static_cast<long>(integrator_steps * share);
  options.most_periods = static_cast<int>(2000 * share);
  return options;
}

void add_adaptive(std::vector<Setting>& all, Method method, double share,
                  const std::vector<double>& tolerances) {
  for (const double tolerance : tolerances) {
    MethodOptions options = limited(share);
    options.tolerance = tolerance;
    all.push_back(
        with(method, fmt::format("{:.0e}", tolerance), accumulation * tolerance, options));
  }
}

void add_moreau(std::vector<Setting>& all, double share) {
  for (const int steps : {100, 400, 1600}) {
    MethodOptions options = limited(share);
    options.steps_per_period = steps;
    options.most_periods = static_cast<int>(integrator_steps * share) / steps;
    all.push_back(
        with(Method::moreau, fmt::format("{} steps", steps), wrong_by_any_measure, options));
  }
}

void add_tanh(std::vector<Setting>& all, double share) {
  for (const double width : {1e-2, 1e-3}) {
    MethodOptions options = limited(share);
    options.tolerance = 1e-2 * width;
    options.regularisation = width;
    all.push_back(
        with(Method::tanh, fmt::format("width {:.0e}", width), wrong_by_any_measure, options));
    all.back().idealised = true;
  }
}

}  // namespace

std::vector<Setting> all_settings(const System& system) {
  std::vector<Setting> all{exact_setting()};
  const double share = affordable_share(system);
  add_moreau(all, share);
  add_adaptive(all, Method::rkf45, share, {1e-4, 1e-6, 1e-8});
  add_adaptive(all, Method::rk8pd, share, {1e-4, 1e-6, 1e-8, 1e-10, 1e-12});
  if (!is_large(system)) {
    add_adaptive(all, Method::msbdf, share, {1e-4, 1e-6, 1e-8});
    add_tanh(all, share);
  }
  if (!system.drive && !system.masses && system.contact.branches.empty()) {
    all.push_back(with(Method::reduced, "", wrong_by_any_measure, {}));
    all.back().idealised = true;
  }
  return all;
}

}  // namespace vcrit::validation::accuracy
