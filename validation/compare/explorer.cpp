#include "compare/explorer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/identifiers.hpp"

#include "compare/system_size.hpp"
#include "critical/admissibility.hpp"
#include "critical/critical_velocity.hpp"
#include "derivation/derivation.hpp"
#include "emit/generate.hpp"
#include "problem/variants.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/curve.hpp"
#include "stiffness/at_rest.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation {

namespace {

using simulation::Regime;

constexpr int stops_per_decade = 5, decades_each_way = 2;  // to each side
constexpr double largest_amplitude = 0.99;                 // of the normal force, over its mean

/// The generated module as the body of a function that returns what it exports.
std::string module_script(const symbolic::Derivation& derivation, const char* name) {
  std::string text = symbolic::emit(derivation, "scene", {.language = "javascript"});
  const std::string word = "\nexport const ";
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at))
    text.replace(at, word.size(), "\nconst ");
  return fmt::format("const {} = (() => {{\n", name) + text +
         "return { critical_velocity, critical_velocity_batch };\n})();\n";
}

/// A name that no parameter of the scene has.
std::string unused_name(const Problem& problem) {
  std::string name = "unit";
  const auto taken = [&](const auto& value) { return value.first.name == name; };
  const Values& values = problem.values();
  while (std::any_of(values.begin(), values.end(), taken)) name += "_";
  return name;
}

std::vector<Slider> sliders(const Problem& problem, const symbolic::Derivation& derivation,
                            const std::vector<ValueLine>& values) {
  std::vector<Slider> result;
  for (const ValueLine& line : values) {
    const auto& used = derivation.parameters;
    const bool moves = line.meaning == "mean indentation" ||
                       std::find(used.begin(), used.end(), line.symbol) != used.end();
    if (!moves) continue;
    const std::string name = as_called(problem, line.symbol).name;
    const auto same = [&](const Slider& slider) { return slider.name == name; };
    auto slider = std::find_if(result.begin(), result.end(), same);
    if (slider == result.end())
      slider = result.insert(slider, {name,
                                      line.name.text.substr(0, line.name.text.find('[')),
                                      line.meaning,
                                      line.unit,
                                      line.name.mathml,
                                      line.symbol.entry > 0,
                                      {}});
    slider->values.push_back(line.value);
  }
  return result;
}

std::vector<double> stops(double omega) {
  std::vector<double> result;
  for (int i = -stops_per_decade * decades_each_way; i <= stops_per_decade * decades_each_way; ++i)
    result.push_back(omega * std::pow(10, static_cast<double>(i) / stops_per_decade));
  return result;
}

std::vector<double> explored_ratios() {
  std::vector<double> result{0.01, 0.03};
  for (int i = 1; i <= 19; ++i) result.push_back(i / 20.0);
  for (const double ratio : {0.97, 0.985, 1.0, 1.2}) result.push_back(ratio);
  return result;
}

/// Friction at one frequency and amplitude.
struct FrictionRow {
  std::vector<double> friction;
  bool backslip = false;
};

/// The scene's contact and drive, at other frequencies and amplitudes of the normal force.
class Simulated {
 public:
  explicit Simulated(const Problem& problem)
      : problem_(problem), values_(problem_.values()), system_(simulation::system_of(problem)) {}

  bool affordable() const { return !is_large(system_); }

  /// Amplitude of the normal force over its mean, by the scene's own oscillation.
  double amplitude_ratio(double omega) const {
    return std::abs(dynamic_stiffness(problem_->normal.reduction(), values_, omega)) *
           values_.at(problem_->amplitude.symbol) / system_.mean_normal_force;
  }

  FrictionRow row(double omega, double amplitude, const std::vector<double>& ratios) const {
    simulation::System system = system_;
    system.omega = omega;
    const auto stiffness = dynamic_stiffness(problem_->normal.reduction(), values_, omega);
    system.normal_force_amplitude =
        stiffness * (amplitude * system.mean_normal_force / std::abs(stiffness));
    const double threshold =
        critical_velocity(problem_, omega) * amplitude / amplitude_ratio(omega) +
        creep_velocity(problem_);
    std::vector<double> velocities;
    for (const double ratio : ratios) velocities.push_back(ratio * threshold);
    FrictionRow result;
    if (!(threshold > 0 && std::isfinite(threshold))) {
      result.friction.assign(ratios.size(), std::numeric_limits<double>::quiet_NaN());
      return result;
    }
    for (const auto& point : simulation::friction_curve(system, velocities)) {
      result.friction.push_back(point.state ? point.state->friction_ratio
                                            : std::numeric_limits<double>::quiet_NaN());
      result.backslip |= point.state && point.state->regime == Regime::stick_slip_backslip;
    }
    return result;
  }

 private:
  Problem problem_;
  const Values& values_;  // its
  simulation::System system_;
};

// Without backward slip friction falls short of mu0 in proportion to the amplitude, and one curve
// is all; else the reader sees what lies between some amplitudes interpolated.
FrictionGrid friction_grid(const Simulated& simulated, double omega) {
  FrictionGrid grid{stops(omega), explored_ratios(), {largest_amplitude}, {}, {}};
  bool backslip = false;
  for (const double at : grid.omegas) {
    const FrictionRow row = simulated.row(at, largest_amplitude, grid.ratios);
    grid.amplitude_ratios.push_back(simulated.amplitude_ratio(at));
    grid.friction.push_back(row.friction);
    backslip |= row.backslip;
  }
  if (!backslip) return grid;
  grid.amplitudes = {0.1, 0.3, 0.5, 0.7, 0.9, largest_amplitude};
  grid.friction.clear();
  for (const double at : grid.omegas)
    for (const double amplitude : grid.amplitudes)
      grid.friction.push_back(simulated.row(at, amplitude, grid.ratios).friction);
  return grid;
}

}  // namespace

std::map<std::string, std::string> names_in_page(const Problem& problem) {
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
  for (const auto& [symbol, value] : problem.values()) taken.insert(symbol.name);
  for (const auto& [symbol, name] : problem->names) {
    if (!unsafe_as_identifier(symbol)) continue;
    std::string other = "element_" + name;
    while (!taken.insert(other).second) other += "_";
    names[symbol] = other;
  }
  return names;
}

std::optional<Explorer> explorer(symbolic::Derivation derivation,
                                 const std::vector<ValueLine>& values) {
  Explorer result;
  derivation.problem = called_otherwise(derivation.problem, names_in_page(derivation.problem));
  const Problem& problem = derivation.problem;
  try {
    result.unit = unused_name(problem);
    result.script =
        "\"use strict\";\n" + module_script(derivation, "vcrit_scene") +
        module_script(symbolic::derive(over_spring(problem, problem->normal, {result.unit})),
                      "vcrit_normal");
  } catch (const ModelError&) {
    return std::nullopt;
  }
  result.sliders = sliders(problem, derivation, values);
  result.carries_load = at_rest(problem->normal.reduction(), problem.values()).stiffness() > 0;
  if (!rules::answer(rules::Question::report_explorer, problem)) return result;
  const Simulated simulated(problem);
  if (simulated.affordable())
    result.friction =
        friction_grid(simulated, problem.values().at(problem->angular_frequency.symbol));
  return result;
}

}  // namespace vcrit::validation
