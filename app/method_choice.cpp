#include "method_choice.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <vector>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::app {

namespace {

/// An option and the methods that take it.
struct Taken {
  const char* option;
  std::vector<std::string> methods;
};

const std::vector<Taken> taken{
    {"--tolerance", {"rkf45", "rk8pd", "msbdf", "tanh"}},
    {"--steps", {"moreau"}},
    {"--theta", {"moreau"}},
    {"--regularisation", {"tanh"}},
    {"--plain", {"moreau", "rkf45", "rk8pd", "msbdf", "tanh"}},
};

std::vector<std::string> names() {
  std::vector<std::string> list{"exact"};
  for (const simulation::Method method : simulation::all_methods())
    list.emplace_back(to_text(method));
  return list;
}

}  // namespace

void MethodChoice::add_to(CLI::App& command) {
  command_ = &command;
  command.add_option("--method", name_, "how the motion is found; exact has all digits")
      ->check(CLI::IsMember(names()))
      ->capture_default_str();
  command.add_option("--start", start_, "where the motion comes from")
      ->check(CLI::IsMember({"sliding", "rest"}))
      ->capture_default_str();
  command.add_option("--tolerance", options_.tolerance, "rkf45, rk8pd, msbdf, tanh: error a step")
      ->capture_default_str();
  command.add_option("--steps", options_.steps_per_period, "moreau: steps a period")
      ->capture_default_str();
  command
      .add_option("--theta", options_.theta,
                  "moreau: 0.5 (second order) to 1 (implicit Euler, first order)")
      ->capture_default_str();
  command
      .add_option("--regularisation", options_.regularisation,
                  "tanh: velocity over which friction turns, in units of the drive's")
      ->capture_default_str();
  command.add_flag("--plain", plain_, "run periods until they repeat, without Newton's method");
}

simulation::Start MethodChoice::start() const {
  return start_ == "rest" ? simulation::Start::rest : simulation::Start::sliding;
}

simulation::SteadyState MethodChoice::steady_state(const simulation::System& system,
                                                   double velocity) const {
  for (const auto& [option, methods] : taken)
    if (command_->count(option) > 0 &&
        std::find(methods.begin(), methods.end(), name_) == methods.end())
      throw InputError({option}, fmt::format("--method {}", name_),
                       fmt::format("{}, which {} it", joined(methods, ", "),
                                   methods.size() == 1 ? "takes" : "take"));
  simulation::MethodOptions options = options_;
  options.newton = !plain_;
  options.start = start();
  const auto method = simulation::method_named(name_);
  return method ? simulation::steady_state(*method, system, velocity, options)
                : simulation::steady_state(system, velocity, options.start);
}

}  // namespace vcrit::app
