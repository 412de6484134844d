// The limits of v_c: for delta -> 0, G = G(0) + delta^2 (v + sin tau2)/(4 pi), which is
// sqrt(1 + delta^2) G(0) where G(0) = (v + sin tau2)/(2 pi). For delta -> infinity the force is
// that of a damper alone, the contact point slips with p + sin tau (over omega du_z) where that is
// positive, its mean velocity is v, and G/sqrt(1 + delta^2) = v - p:
//   [sqrt(1 - p^2) + p (pi/2 + asin p)]/pi = v.
#include "paper/viscosity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "base/constants.hpp"
#include "compare/friction.hpp"
#include "paper/comparing.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"
#include "paper/scenes.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit::validation::paper {

namespace {

using Curve = std::function<double(double ratio)>;

constexpr double digits_given = 1e-15;  // of values below 1, in the table
constexpr double closed_form_rounding =
    2e-14;  // of the elastic G: twenty roundings of terms up to 4

double elastic_g(double ratio) { return 1 - elastic_friction(1, ratio); }

/// What is taken away of mu/mu0, per amplitude a of the normal force, and the error of that.
struct Taken {
  double value = 0, error = 0;
};
Taken taken(double delta, double ratio) {
  const auto motion = full_motion(delta, reference_amplitude, ratio);
  return {(1 - motion.friction_ratio) / reference_amplitude,
          (motion.friction_ratio_error + friction_rounding) / reference_amplitude};
}

double relaxed(double ratio) {
  double low = -1, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double p = (low + high) / 2;
    const double passed = (std::sqrt(1 - p * p) + p * (pi / 2 + std::asin(p))) / pi;
    (passed < ratio ? low : high) = p;
  }
  return ratio - low;
}

double taken_at(double delta, double ratio) {
  return std::isinf(delta) ? relaxed(ratio) : taken(delta, ratio).value;
}

/// Less what the elastic contact loses: below 0 where viscosity weakens the effect.
Curve strengthening(double delta) {
  return [delta](double ratio) { return taken_at(delta, ratio) - elastic_g(ratio); };
}

double root(const Curve& rising, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (rising(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// (v + sin tau2)/(2 pi) - G(0), which is 0 at v_c for delta -> 0.
double first_strengthening(double ratio) {
  const auto events = full_motion(0, reference_amplitude, ratio).events;
  const auto end_of_stick = std::find_if(events.begin(), events.end(), [](const auto& event) {
    return event.to == simulation::Motion::slip;
  });
  if (end_of_stick == events.end()) throw Bug("no stick below v*");
  return (ratio + std::sin(end_of_stick->phase)) / two_pi - elastic_g(ratio);
}

double maximum(const Curve& curve, double low, double high) {
  constexpr int half_the_bits = 26;  // where a maximum is flat, no more of its place is known
  return -boost::math::tools::brent_find_minima([&](double x) { return -curve(x); }, low, high,
                                                half_the_bits)
              .second;
}

Crossing crossing_of(double delta) {
  const Curve curve = delta == 0 ? Curve(first_strengthening) : strengthening(delta);
  Crossing found{delta, root(curve, 0.4, 0.9), 0, 0};
  if (delta == 0) return found;
  found.weakening = maximum([&](double x) { return -curve(x); }, 0.005, found.ratio);
  found.strengthening = maximum(curve, found.ratio, 0.999);
  return found;
}

std::string of_delta(double delta) {
  if (delta == 0) return "δ → 0";
  return std::isinf(delta) ? "δ → ∞" : fmt::format("δ = {}", delta);
}

/// By what the friction's own errors, some 1e-14 near v_c, may move it.
double crossing_error(double delta, double ratio) {
  constexpr double aside = 0.01;  // a slope by differences, of which two digits do
  const Curve curve = delta == 0 ? Curve(first_strengthening) : strengthening(delta);
  const double slope = (curve(ratio + aside) - curve(ratio - aside)) / (2 * aside);
  const double error = delta > 0 && std::isfinite(delta) ? taken(delta, ratio).error : 0;
  return (error + closed_form_rounding) / slope + digits_given;
}

void compare_crossing(Viscosity& result, const CrossingReference& known) {
  const Crossing found = crossing_of(known.delta);
  result.crossings.push_back(found);
  const auto add = [&](const char* key, const char* name, double expected, double value,
                       double tolerance, const char* reason) {
    result.comparisons.push_back(
        comparison({key, fmt::format("{}, {}", name, of_delta(known.delta)),
                    "15 digits, Newton’s method on the events", reason},
                   {expected, value, tolerance, ""}));
  };
  add("crossing", "v_c/v*, where viscosity changes nothing at equal a", known.ratio, found.ratio,
      crossing_error(known.delta, known.ratio), "errors of both frictions over the slope there");
  if (known.delta == 0) return;
  constexpr double rounding = 2 * closed_form_rounding;  // as much again for the simulated one
  const char* reason = "errors of both frictions: twenty roundings of terms up to 4 in each";
  add("most_weakening", "most weakening, per a", known.weakening, found.weakening, rounding,
      reason);
  add("most_strengthening", "most strengthening, per a", known.strengthening, found.strengthening,
      rounding, reason);
}

Comparison against_table(double delta) {
  std::vector<Pair> pairs;
  for (const ViscosityReference& row : viscosity_references()) {
    if (row.delta != delta) continue;
    const Taken found = taken(delta, row.ratio);
    pairs.push_back({row.per_a, found.value, found.error + digits_given,
                     fmt::format("worst at v₀/v* = {}", row.ratio)});
  }
  return worst({"viscosity", fmt::format("reduction of friction per a, δ = {}", delta),
                "15 digits, Newton’s method on the events",
                "the simulator’s own estimate, a rounding of each, and the last digit given"},
               pairs);
}

/// At equal D, between one delta of the table and the next: never less with more viscosity.
Comparison ever_stronger() {
  std::vector<Pair> pairs;
  const auto rows = viscosity_references();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].ratio != rows[i - 1].ratio) continue;
    const Taken before = taken(rows[i - 1].delta, rows[i].ratio),
                after = taken(rows[i].delta, rows[i].ratio);
    const double less = std::hypot(1, rows[i - 1].delta), more = std::hypot(1, rows[i].delta);
    pairs.push_back({0, std::min(0.0, after.value * more - before.value * less),
                     before.error * less + after.error * more,
                     fmt::format("worst at v₀/v* = {}", rows[i].ratio)});
  }
  return worst({"stronger", "most that G falls from one δ to the next, at equal D", "never falls",
                "the simulator’s own estimates for both"},
               pairs);
}

/// Isotropic contacts of many rheologies under a rigid drive, at one amplitude and speed, against
/// the elastic contact with their stiffness at rest.
Comparison any_rheology() {
  std::vector<Pair> pairs;
  for (const char* contact : contacts) {
    simulation::System system =
        simulation::system_of(driven_problem(contact, "tangential_ratio = 0.7", "", false));
    const double amplitude = std::abs(system.normal_force_amplitude);
    const double scale = reference_amplitude * system.mean_normal_force / amplitude;
    system.normal_force_amplitude *= scale;
    const double d = scale * 0.1;  // the scene's du_z/u_z0
    const double threshold = simulation::sliding_threshold(system).contact_velocity;
    for (const double ratio : {0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
      const auto motion = simulation::steady_state(system, ratio * threshold);
      pairs.push_back({0, std::max(0.0, motion.friction_ratio - elastic_friction(d, ratio)),
                       motion.friction_ratio_error + closed_form_rounding,
                       fmt::format("worst with {} at v₀/v* = {}", contact, ratio)});
    }
  }
  return worst(
      {"any_rheology",
       "most that an isotropic contact has more friction than the elastic one, equal D",
       "never more", "the simulator’s own estimate, and twenty roundings of terms up to 4"},
      pairs);
}

/// Of mu/mu0 at v0/v* = 0.1 and the largest amplitude, a = 1, by proportion.
Comparison initial(const ViscosityReference& row) {
  const Taken found = taken(row.delta, row.ratio);
  return comparison({"initial", fmt::format("friction at v₀/v* = 0.1 and D_max, δ = {}", row.delta),
                     "15 digits, Newton’s method on the events",
                     "the simulator’s own estimate, a rounding of each, and the last digit given"},
                    {1 - row.per_a, 1 - found.value, found.error + digits_given, ""});
}

/// delta = 100, D = 0.009 at v0/v* = 0.1.
Comparison tiny_amplitude(double delta, const char* name) {
  constexpr double amplitude = 0.009, ratio = 0.1;
  const auto rows = viscosity_references();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const ViscosityReference& r) {
    return r.delta == delta && r.ratio == ratio;
  });
  const double a = amplitude * std::hypot(1, delta);
  const Taken found = taken(delta, ratio);
  return comparison({"tiny_amplitude", fmt::format("friction at D = 0.009, v₀/v* = 0.1, {}", name),
                     "15 digits, Newton’s method on the events",
                     "the simulator’s own estimate, a rounding of each, and the last digit given"},
                    {1 - a * row->per_a, 1 - a * found.value, found.error + digits_given, ""});
}

template <class Value>
figures::Figure figure_of(const char* name, const char* title, const char* caption,
                          const figures::FigureAxis& y, const std::vector<double>& deltas,
                          Value value) {
  figures::Figure figure;
  figure.name = name;
  figure.title = title;
  figure.caption = caption;
  figure.x = {"v₀ / v*", false, std::pair{0.0, 1.0}, {}};
  figure.y = y;
  figure.height = 260;
  int colour = 0;
  for (const double delta : deltas) {
    figures::FigureSeries series{of_delta(delta), figures::Style::line, {}, colour++};
    for (int i = 1; i < 100; ++i) series.points.push_back({i / 100.0, value(delta, i / 100.0), {}});
    figure.series.push_back(std::move(series));
  }
  return figure;
}

std::vector<figures::Figure> drawn() {
  const double inf = std::numeric_limits<double>::infinity();
  figures::Figure force =
      figure_of("equal_relative_amplitude", "Equal relative amplitude D/D_max",
                "What the oscillation takes away of μ/μ₀, per a = D/D_max, less what it takes from "
                "an elastic "
                "contact. Below 0, viscosity weakens the effect.",
                {"reduction, less elastic", false, std::nullopt, {}}, {0.3, 1, 2, 10, inf},
                [](double delta, double ratio) { return strengthening(delta)(ratio); });
  force.rules.push_back({0, "elastic", true});
  figures::Figure amplitude = figure_of(
      "equal_amplitude", "Equal amplitude D",
      "What the oscillation takes away of μ/μ₀, over what it takes from an elastic contact at the "
      "same amplitude. Above 1, viscosity strengthens the effect.",
      {"reduction, over elastic", true, std::nullopt, {}}, {0.3, 1, 2, 10, 100},
      [](double delta, double ratio) {
        return taken(delta, ratio).value * std::hypot(1, delta) / elastic_g(ratio);
      });
  return {force, amplitude};
}

}  // namespace

Viscosity compare_viscosities() {
  Viscosity result;
  for (const double delta : {0.0, 0.1, 0.3, 1.0, 2.0, 10.0, 100.0})
    result.comparisons.push_back(against_table(delta));
  result.comparisons.push_back(ever_stronger());
  result.comparisons.push_back(any_rheology());
  for (const ViscosityReference& row : viscosity_references())
    if (row.ratio == 0.1) result.comparisons.push_back(initial(row));
  for (const CrossingReference& known : crossing_references()) compare_crossing(result, known);
  result.comparisons.push_back(tiny_amplitude(100, "δ = 100"));
  result.comparisons.push_back(tiny_amplitude(0, "elastic"));
  result.figures = drawn();
  return result;
}

}  // namespace vcrit::validation::paper
