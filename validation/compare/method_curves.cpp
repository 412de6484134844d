#include "compare/method_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "compare/system_size.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::validation {

namespace {

using simulation::Method;

// Of v*: one next to it, where sticks are short, and one above, where none is left.
constexpr double method_ratios[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97, 1.05};

std::string setting(Method method, const simulation::MethodOptions& options) {
  switch (method) {
    case Method::moreau:
      return fmt::format("{} steps a period", options.steps_per_period);
    case Method::tanh:
      return fmt::format("regularised over {} of the speed", options.regularisation);
    case Method::reduced:
      return "(47)-(52)";
    case Method::rkf45:
    case Method::rk8pd:
    case Method::msbdf:
      return fmt::format("tolerance {}", options.tolerance);
  }
  throw Bug("a method without a setting");
}

MethodPoint method_point(Method method, const simulation::System& system, double threshold,
                         double ratio, double exact) {
  MethodPoint result;
  result.ratio = ratio;
  try {
    const auto state =
        simulation::steady_state(method, system, ratio * threshold, affordable(system));
    result.friction_ratio = state.friction_ratio;
    result.difference = std::abs(state.friction_ratio - exact);
  } catch (const ModelError& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace

std::vector<MethodCurve> method_curves(const simulation::System& system, double threshold) {
  std::vector<double> exact;
  for (const double ratio : method_ratios)
    exact.push_back(simulation::steady_state(system, ratio * threshold).friction_ratio);
  std::vector<MethodCurve> curves;
  for (const Method method : simulation::all_methods()) {
    if (is_large(system) && (method == Method::msbdf || method == Method::tanh)) continue;
    MethodCurve curve{to_text(method), setting(method, affordable(system)), {}};
    for (std::size_t i = 0; i < exact.size(); ++i)
      curve.points.push_back(method_point(method, system, threshold, method_ratios[i], exact[i]));
    if (std::any_of(curve.points.begin(), curve.points.end(),
                    [](const MethodPoint& one) { return one.reason.empty(); }))
      curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace vcrit::validation
