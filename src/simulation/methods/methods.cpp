#include "simulation/methods/methods.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/gsl_errors.hpp"
#include "simulation/methods/moreau.hpp"
#include "simulation/methods/reduced.hpp"
#include "simulation/methods/steady.hpp"
#include "simulation/methods/switching.hpp"
#include "simulation/methods/tanh_friction.hpp"
#include "simulation/system/check.hpp"

namespace vcrit::simulation {

namespace {

constexpr std::array known_methods{Method::moreau, Method::rkf45, Method::rk8pd,
                                   Method::msbdf,  Method::tanh,  Method::reduced};

// Some 200 MB of bounds and forces; a motion of so many steps is beyond the bound on work after a
// few periods.
constexpr int most_steps_per_period = 10'000'000;

// The error estimate compares with the same motion at a tenth to a thirtieth of the accuracy, which
// has to be a motion still: with 0.1 the friction of `tanh` came out negative.
constexpr double loosest_tolerance = 1e-3;

// Beyond the drive's own velocity the smoothed law is that of a damper, and the estimate, which
// compares with three times the width, sees two wrong answers that agree.
constexpr double widest_regularisation = 1;
// The contact force of a stuck contact is told by its creep, of which doubles leave nothing.
constexpr double narrowest_regularisation = 1e-12;
// An error of a step as large as the width is an error of the whole friction force.
constexpr double tolerance_per_width = 0.1;

void check(Method method, const MethodOptions& options) {
  const auto require = [](bool holds, const char* option, auto found, std::string expected) {
    if (!holds) throw InputError(argument(option), fmt::format("{}", found), std::move(expected));
  };
  require(options.tolerance >= 1e-15 && options.tolerance <= loosest_tolerance, "tolerance",
          options.tolerance, "a number from 1e-15 to 0.001");
  require(options.steps_per_period >= 4 && options.steps_per_period <= most_steps_per_period,
          "steps", options.steps_per_period, "a number from 4 to 10000000");
  require(options.theta >= 0.5 && options.theta <= 1, "theta", options.theta,
          "a number from 0.5 to 1");
  require(options.regularisation >= narrowest_regularisation &&
              options.regularisation <= widest_regularisation,
          "regularisation", options.regularisation, "a number from 1e-12 to 1");
  const double most = tolerance_per_width * options.regularisation;
  require(method != Method::tanh || options.tolerance <= most, "tolerance", options.tolerance,
          fmt::format("at most {:.3g}, a tenth of the regularisation", most));
}

std::unique_ptr<methods::PeriodMap> period_map(Method method, const System& system, double velocity,
                                               const MethodOptions& options) {
  switch (method) {
    case Method::moreau:
      return methods::moreau_map(system, velocity, options);
    case Method::rkf45:
    case Method::rk8pd:
    case Method::msbdf:
      return methods::switching_map(method, system, velocity, options);
    case Method::tanh:
      return methods::tanh_map(system, velocity, options);
    case Method::reduced:
      break;
  }
  throw Bug("the reduced model has no period map");
}

}  // namespace

std::span<const Method> all_methods() { return known_methods; }

const char* to_text(Method method) {
  switch (method) {
    case Method::moreau:
      return "moreau";
    case Method::rkf45:
      return "rkf45";
    case Method::rk8pd:
      return "rk8pd";
    case Method::msbdf:
      return "msbdf";
    case Method::tanh:
      return "tanh";
    case Method::reduced:
      return "reduced";
  }
  throw Bug("a method is one of six");
}

std::optional<Method> method_named(std::string_view name) {
  const auto found = std::find_if(known_methods.begin(), known_methods.end(),
                                  [&](Method method) { return name == to_text(method); });
  return found == known_methods.end() ? std::nullopt : std::optional(*found);
}

SteadyState steady_state(Method method, const System& system, double velocity,
                         const MethodOptions& options) {
  require_forward(velocity);
  check(method, options);
  check_system(system);
  const GslErrorsOff errors_off;
  if (method == Method::reduced) return methods::reduced_model(system, velocity);
  try {
    return methods::settle(*period_map(method, system, velocity, options), options);
  } catch (const ModelError& error) {
    throw ModelError(fmt::format("{} {}", to_text(method), error.what()));
  }
}

}  // namespace vcrit::simulation
