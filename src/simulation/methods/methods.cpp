#include "simulation/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/methods/gsl_errors.hpp"
#include "simulation/methods/moreau.hpp"
#include "simulation/methods/steady.hpp"
#include "simulation/methods/switching.hpp"
#include "simulation/methods/tanh_friction.hpp"

namespace vcrit::simulation {

namespace {

constexpr std::array all{Method::moreau, Method::rkf45, Method::rk8pd,
                         Method::msbdf,  Method::tanh,  Method::reduced};

void require(bool holds, const char* option, double found, const char* expected) {
  if (!holds) throw InputError({option}, fmt::format("{}", found), expected);
}

}  // namespace

std::span<const Method> all_methods() { return all; }

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
  const auto found =
      std::find_if(all.begin(), all.end(), [&](Method method) { return name == to_text(method); });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

SteadyState steady_state(Method method, const System& system, double velocity,
                         const MethodOptions& options) {
  ensure(velocity > 0, "the drive moves forward");
  require(options.tolerance > 0, "tolerance", options.tolerance, "a number above 0");
  const methods::GslErrorsOff errors_off;
  const auto map = method == Method::moreau ? methods::moreau_map(system, velocity, options) : method==Method::tanh ? methods::tanh_map(system, velocity, options) : methods::switching_map(method, system, velocity, options);
  return methods::settle(*map, options);
}

}  // namespace vcrit::simulation
