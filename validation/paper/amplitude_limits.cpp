// The largest amplitudes without loss of contact, printed with Fig. 4, by formula and by two checks
// that reject a scene.
#include <fmt/core.h>

#include <cmath>
#include <functional>

#include "critical/admissibility.hpp"
#include "paper/comparing.hpp"
#include "paper/limits.hpp"
#include "paper/references.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation::paper {

namespace {

Problem kelvin_problem(double delta, double amplitude) {
  return parse_problem(
      fmt::format("[contact]\nnormal = \"kelvin(k, c)\"\ntangential_ratio = 1.0\n[oscillation]\n"
                  "angular_frequency = 1.0\namplitude = {}\nindentation = 1.0\n[friction]\n"
                  "coefficient = 1.0\n[elements]\nk = 1.0\nc = {:.17g}\n",
                  amplitude, delta),
      "paper");
}

bool admissible(const Problem& problem) { return inadmissible_reasons(problem).empty(); }

bool simulator_takes(const Problem& problem) {
  try {
    simulation::system_of(problem);
    return true;
  } catch (const ModelError&) {
    return false;
  }
}

/// The largest D that is accepted, to a rounding error.
double bisect(double delta, const std::function<bool(const Problem&)>& accepts) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (accepts(kelvin_problem(delta, middle)) ? low : high) = middle;
  }
  return (low + high) / 2;
}

void compare_amplitude_limit(AmplitudeLimits& limits, const AmplitudeLimit& row, double half_unit) {
  const auto add = [&](const char* key, const std::string& name, const char* reference,
                       double found, double expected, double tolerance, const char* reason) {
    limits.comparisons.push_back(comparison(
        {key, fmt::format("largest D at δ = {}, {}", row.delta, name), reference, reason},
        {expected, found, tolerance, ""}));
  };
  add("jump_printed", "1/√(1 + δ²)", "printed in the paper", row.formula, row.printed, half_unit,
      "half a unit of the last digit printed");
  const double rounding = 8 * 0x1p-53 * row.formula;
  const char* reason = "four roundings in each of the two";
  add("jump_admissible", "bisection on admissibility", "1/√(1 + δ²)", row.by_admissibility,
      row.formula, rounding, reason);
  add("jump_simulator", "bisection on the simulator", "1/√(1 + δ²)", row.by_simulator, row.formula,
      rounding, reason);
}

}  // namespace

AmplitudeLimits find_amplitude_limits() {
  AmplitudeLimits limits;
  for (const PrintedLimit& printed : printed_limits()) {
    const double delta = printed.delta;
    limits.rows.push_back({delta, printed.amplitude, 1 / std::hypot(1, delta),
                           bisect(delta, admissible), bisect(delta, simulator_takes)});
    compare_amplitude_limit(limits, limits.rows.back(), printed.half_unit);
  }
  return limits;
}

}  // namespace vcrit::validation::paper
