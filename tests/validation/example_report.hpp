// A report written by hand: what the page does with it can be known beforehand.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "report/report_json.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

namespace vcrit::validation::example {

inline const test::SceneText rigid_contact{.tangential = "kt",
                                           .angular_frequency = 125664,
                                           .amplitude = 1e-7,
                                           .indentation = 3e-7,
                                           .coefficient = 0.3,
                                           .elements = {{"kn", 11.5e6}, {"kt", 9.47e6}}};
inline const std::string rigid_scene =
    "title = \"Elastic contact\"\n" + test::to_toml(rigid_contact);

inline const std::string driven_scene =
    "title = \"Everything there is\"\n" + test::to_toml({.normal = "bridge",
                                                         .tangential_ratio = 0.8,
                                                         .network = "kd | (k4 - c4)",
                                                         .mass = "0.3 g",
                                                         .frequency = "40 kHz",
                                                         .amplitude = "60 nm",
                                                         .indentation = "0.6 um",
                                                         .coefficient = 0.2,
                                                         .elements = {{"k1", 20e6},
                                                                      {"k2", 30e6},
                                                                      {"k3", 25e6},
                                                                      {"c1", 12},
                                                                      {"c2", 18},
                                                                      {"kd", 5e6},
                                                                      {"k4", 2e6},
                                                                      {"c4", 8}},
                                                         .more = test::bridge_network});

inline ShownFormula formula(const std::string& letter) {
  return {"<math><mi>" + letter + "</mi></math>", letter, letter};
}

/// Of a contact with delta = 1.5; the numbers tell row and column.
inline ReducedModel reduced_model() {
  return {1.5,
          0.01,
          0.62,
          {0.8, {0.1, 0.9}, {0.3, 1.5}, {{{0.9, 0.65}, {0.8, 0.8}}, {{0.7, 0.6}, {0.5, 0.501}}}}};
}

/// Passes; 2 percent of room in its tolerance's units.
inline Comparison comparison(const std::string& key, double expected) {
  Comparison result;
  result.key = key;
  result.name = "way called " + key;
  result.reference = "the reference";
  result.unit = "m/s";
  result.expected = expected;
  result.found = expected * (1 + 1e-12);
  result.tolerance = 1e-9;
  result.reason = "a reason for it";
  return result;
}

inline ComparedPoint curve_point(double ratio, double velocity) {
  const double friction = ratio < 1 ? 1 - 0.4 * (1 - ratio) * (1 - ratio) : 1;
  return {ratio, ratio * velocity, friction, friction, 1e-12, ratio < 1 ? "stick-slip" : "sliding",
          {}};
}

inline Cycle cycle(double velocity) {
  Cycle result{0.5, velocity / 2, 0.9, "stick-slip", {}, {}};
  for (int i = 0; i < 200; ++i) {
    const double phase = i * std::numbers::pi / 100;
    const bool stick = phase > 3 && phase < 5;
    result.points.push_back({phase, stick ? 0 : velocity * (0.5 + 0.4 * std::sin(phase)),
                             0.8 + 0.2 * std::cos(phase), 1 + 0.2 * std::cos(phase)});
  }
  result.events = {{3, simulation::Motion::stick}, {5, simulation::Motion::slip}};
  return result;
}

inline SceneReport scene_report(const Scene& scene) {
  SceneReport report(scene);
  report.critical_velocity = 0.0045779;
  report.relative_error_bound = 1e-16;
  report.condition = 6;
  report.formula.formula = formula("F");
  report.derivation = {{"The balance of the contact point:", formula("L"), formula("R")}};
  report.limits = {
      {"c -> 0", "(30)", "<math><mi>c</mi><mo>→</mo><mn>0</mn></math>", formula("Z"), {}}};
  report.values = {{{"kn", 0}, formula("kn"), 11.5e6, "N/m", "spring"}};
  Effect& effect = report.effect.emplace();
  effect.frequency = 20000;
  effect.amplitude = 1e-7;
  effect.indentation = 3e-7;
  effect.friction_coefficient = 0.3;
  effect.mean_normal_force = 3.45;
  effect.largest_closed_amplitude = 3e-7;
  effect.critical_velocity = effect.drive_velocity = effect.reduced_below = 0.0045779;
  effect.lowest = 0.6;
  report.normal_force = {3.45, 1.15};
  report.influences = {{"mu0", formula("M"), "coefficient of friction", false, 1},
                       {"kt", formula("T"), "spring", false, -0.5},
                       {"kn", formula("N"), "spring", false, 0.25}};
  report.comparisons = {comparison("formula", 0.0045779), comparison("simulation", 0.0045779)};
  for (int i = 1; i <= 28; ++i)
    report.curve.push_back(curve_point(i / 20.0, report.critical_velocity));
  report.cycle = cycle(report.critical_velocity);
  return report;
}

inline SceneReport scene_report(const std::string& text, const std::string& file = "scene.toml") {
  return scene_report(parse_scene(text, file));
}

inline report::Origin origin() {
  return {{"A processor",
           2,
           "An operating system",
           "0.1.0",
           "0123456789ab",
           "-O3",
           {{"A part", "1.2.3"}}},
          "vcrit validate scene.toml --out report"};
}

}  // namespace vcrit::validation::example
