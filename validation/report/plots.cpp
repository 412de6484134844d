#include "report/plots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "answers/effect.hpp"
#include "answers/friction.hpp"
#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "compare/frequency_points.hpp"
#include "compare/steady_cycle.hpp"
#include "report/cycle_figures.hpp"
#include "report/units.hpp"
#include "rules/rulebook.hpp"
#include "simulation/system/system.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;

// Two a pixel of a printed column; each costs a few milliseconds at most.
constexpr int speeds = 160;
// Beyond v*, so that one sees that nothing is gained there.
constexpr double shown_beyond = 1.3;

// The last of them, over the first.
constexpr double span = 1000;

bool can_be_divided(double to) { return to / span > 0 && std::isfinite(to * speeds); }

/// Even, with more of them below v*, where friction rises ever faster.
std::vector<double> speeds_up_to(double to, double onset) {
  std::vector<double> all{to / span};
  for (int i = 1; i <= speeds; ++i) all.push_back(to * i / speeds);
  if (onset > 0 && onset < to) {
    for (double gap = 1.0 / 128; gap > 1e-4; gap /= 2) all.push_back(onset * (1 - gap));
    all.push_back(onset);
  }
  std::sort(all.begin(), all.end());
  return all;
}

double end_of_speeds(const CriticalOnset& onset, std::optional<double> to) {
  if (to && !can_be_divided(*to))
    throw InputError(argument("to"), "a speed of " + rounded(*to, "m/s"),
                     "a speed above 0, with room for the picture's others within the range of "
                     "doubles");
  if (to) return *to;
  if (std::isinf(onset.drive_velocity))
    throw ModelError(onset.reason + ": no speed ends the picture", "give the largest one, `to`");
  if (onset.drive_velocity == 0)
    throw ModelError("v* is 0: friction is the same at every speed, there is nothing to draw",
                     "give the largest speed, `to`");
  const double end = shown_beyond * onset.drive_velocity;
  require_si_doubles(can_be_divided(end));
  return end;
}

const std::string& title_or_file(const Problem& problem) {
  return problem->source->title.empty() ? problem->source->file : problem->source->title;
}

std::string onset_words(const CriticalOnset& onset) {
  const std::string words = "v* = " + quantity(onset.contact_velocity, "m/s", 4);
  if (onset.drive_velocity == onset.contact_velocity) return words;
  return words + ", with creep " + quantity(onset.drive_velocity, "m/s", 4);
}

/// v* over the frequencies of the response, simulated where it is not Eq. (24); NaN outside the
/// model. Throws ModelError where there is none to draw.
std::vector<figures::Point> onsets(const Problem& problem, const FrequencyResponse& response) {
  std::vector<figures::Point> points;
  std::optional<ModelError> first;
  const bool has_formula{rules::answer(rules::Question::derivation, problem)};
  for (const ResponsePoint& at : response.points) {
    const bool known = has_formula && at.applies;
    points.push_back({at.omega / two_pi, known ? at.velocity : std::nan(""), ""});
    if (known || !(problem->separation || at.applies)) continue;
    try {
      points.back().y = quick_onset(problem, at.omega);
    } catch (const ModelError& error) {
      if (!first) first = error;
    }
  }
  if (std::any_of(points.begin(), points.end(),
                  [](const figures::Point& p) { return std::isfinite(p.y) && p.y > 0; }))
    return points;
  if (first) throw ModelError(*first);
  rules::require(rules::Question::admissible, problem);
  throw ModelError("v* is 0 or infinite at every frequency: there is nothing to draw");
}

/// Whole decades. A resonance without damping has no end, so that what is far above most of the
/// velocities is left out, and of an antiresonance what is far below them.
std::pair<double, double> shown_velocities(const std::vector<figures::Point>& points) {
  constexpr double kept = 100;  // two decades beyond what nine of ten points have
  std::vector<double> all;
  for (const figures::Point& point : points)
    if (point.y > 0 && std::isfinite(point.y)) all.push_back(point.y);
  if (all.empty()) return {1, 10};
  std::sort(all.begin(), all.end());
  const double low = std::max(all.front(), all[all.size() / 20] / kept),
               high = std::min(all.back(), all[all.size() - 1 - all.size() / 20] * kept);
  const double begin = std::floor(std::log10(low)), end = std::ceil(std::log10(high));
  return {std::pow(10, begin), std::pow(10, std::max(end, begin + 1))};
}

double middle_of(std::vector<figures::Point> points) {
  std::erase_if(points, [](const figures::Point& point) { return !std::isfinite(point.y); });
  if (points.empty()) return 1;
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  std::nth_element(points.begin(), middle, points.end(),
                   [](const figures::Point& a, const figures::Point& b) { return a.y < b.y; });
  return middle->y;
}

}  // namespace

std::vector<Figure> friction_plot(const Problem& problem, std::optional<double> to) {
  const SteadyFriction friction(problem);
  const CriticalOnset onset = critical_onset(problem);
  const double end = end_of_speeds(onset, to);
  const std::vector<double> velocities = speeds_up_to(end, onset.drive_velocity);
  const Scale scale = scale_for(end, "m/s");
  figures::FigureSeries series;
  std::vector<double> ratios(velocities.size(), std::nan(""));
  friction.curve(
      velocities,
      [&](std::size_t i, const simulation::PassingPoint& point) {
        if (point.state != nullptr) ratios[i] = point.state->friction_ratio;
      },
      indenter::drawn_tolerance);
  for (std::size_t i = 0; i < velocities.size(); ++i)
    series.points.push_back({velocities[i] * scale.factor, ratios[i], ""});
  Figure figure;
  figure.name = "friction";
  figure.title = title_or_file(problem);
  figure.caption = "Mean friction with vibration, over that without, over the sliding speed.";
  figure.x = {"sliding speed, " + scale.unit, false, std::pair{0.0, end * scale.factor}, {}};
  figure.y = {"friction / friction without vibration", false, std::pair{0.0, 1.05}, {}};
  figure.series.push_back(std::move(series));
  if (onset.drive_velocity <= end)
    figure.rules.push_back({onset.drive_velocity * scale.factor, onset_words(onset), false});
  if (const auto lowest = effect_of(problem, onset).lowest; lowest && *lowest < 1)
    figure.rules.push_back({*lowest, rounded(*lowest, "", 3) + " at rest", true});
  return {figure};
}

std::vector<Figure> frequency_plot(const Problem& problem) {
  const FrequencyResponse response = frequency_points(problem);
  if (response.points.empty()) {
    rules::require(rules::Question::all_frequencies, problem);
    throw Bug("a scene of all frequencies without a response");
  }
  figures::FigureSeries series;
  series.points = onsets(problem, response);
  const Scale frequency = scale_for(response.omega / two_pi, "Hz"),
              velocity = scale_for(middle_of(series.points), "m/s");
  for (figures::Point& point : series.points) {
    point.x *= frequency.factor;
    point.y *= velocity.factor;
  }
  Figure figure;
  figure.name = "critical_velocity";
  figure.title = title_or_file(problem);
  figure.caption = "Critical velocity over the frequency, all else as in the scene.";
  figure.x = {"frequency, " + frequency.unit,
              true,
              std::pair{series.points.front().x, series.points.back().x},
              {}};
  figure.y = {"critical velocity v*, " + velocity.unit, true, shown_velocities(series.points), {}};
  figure.series.push_back(std::move(series));
  const auto mark = [&](double omega, const char* words) {
    figure.rules.push_back({omega / two_pi * frequency.factor, words, false});
  };
  mark(response.omega, "this scene");
  for (const ResonanceMark& each : response.marks)
    mark(each.omega, each.resonance ? "resonance" : "antiresonance");
  return {figure};
}

std::vector<Figure> cycle_plot(const Problem& problem, double velocity) {
  rules::require(rules::Question::motion, problem);
  SceneReport report(problem);
  report.cycle = steady_cycle(simulation::system_of(problem), velocity);
  std::vector<Figure> all{force_figure(report), velocity_figure(report)};
  all.front().title =
      fmt::format("{}, at {}", title_or_file(problem), quantity(velocity, "m/s", 4));
  all.back().title.clear();
  all.back().caption = fmt::format("At a sliding speed of {}: friction ratio {:.4g}, {}.",
                                   quantity(velocity, "m/s", 4), report.cycle->friction_ratio,
                                   motion_words(report.cycle->regime));
  return all;
}

}  // namespace vcrit::validation::report
