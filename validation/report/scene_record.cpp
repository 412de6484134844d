// What a scene's findings say of themselves (records.hpp).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/answer_figures.hpp"
#include "report/answer_record.hpp"
#include "report/claims.hpp"
#include "report/cycle_figures.hpp"
#include "report/explorer_record.hpp"
#include "report/indenter_figures.hpp"
#include "report/records.hpp"
#include "report/scene_figures.hpp"
#include "report/separation_figures.hpp"
#include "report/system_drawing.hpp"
#include "report/units.hpp"
#include "report/verdict.hpp"

namespace vcrit::record {

namespace simulation = vcrit::simulation;
namespace report = validation::report;
using validation::SceneReport;

void fields(Fields& f, const validation::ValueLine& it) {
  f("name", it.name.text)("value", it.value)("unit", it.unit)("meaning", it.meaning);
  f.page("sign", Markup{it.name.mathml});
}

void fields(Fields& f, const validation::Influence& it) {
  f("name", it.name)("logarithmic_derivative", it.share);
}

void fields(Fields& f, const validation::NormalForce& it) {
  f("mean", it.mean)("amplitude", it.amplitude);
}

void fields(Fields& f, const validation::ComparedPoint& it) {
  f("velocity_ratio", it.ratio)("velocity", it.velocity)("friction_ratio", it.from_sliding);
  f("friction_ratio_from_rest", it.from_rest)("friction_ratio_error", it.error);
  f("regime", it.regime).some("friction_ratio_closed_form", it.closed_form);
}

void fields(Fields& f, const simulation::CyclePoint& it) {
  f("phase", it.phase)("contact_velocity", it.contact_velocity)("force", it.force);
  f("friction_bound", it.friction_bound);
}

void fields(Fields& f, const simulation::Event& it) { f("phase", it.phase)("to", it.to); }

void fields(Fields& f, const validation::Cycle& it) {
  f("velocity_ratio", it.ratio)("velocity", it.velocity)("friction_ratio", it.friction_ratio);
  f("regime", it.regime)("events", it.events)("points", it.points);
}

void fields(Fields& f, const validation::MethodPoint& it) {
  const bool answered = it.reason.empty();
  f("velocity_ratio", it.ratio).some("reason", it.reason);
  f.when(answered, "friction_ratio", it.friction_ratio).when(answered, "difference", it.difference);
}

/// A method's first reason stands for all.
void fields(Fields& f, const validation::MethodCurve& it) {
  f("method", it.method)("setting", it.setting)("points", it.points);
  std::vector<double> silent_at;
  std::string reason;
  for (const validation::MethodPoint& point : it.points) {
    if (point.reason.empty()) continue;
    silent_at.push_back(point.ratio);
    if (reason.empty()) reason = point.reason;
  }
  f.page("silent_at", silent_at).page("first_reason", reason);
}

void fields(Fields& f, const validation::ResponsePoint& it) {
  f("angular_frequency", it.omega)("normal_stiffness", it.normal);
  f("tangential_stiffness", it.tangential).some("drive_stiffness", it.drive);
  f("critical_velocity", it.velocity)("applies", it.applies);
}

void fields(Fields& f, const validation::AsymptoteLine& it) {
  f("at", it.low ? "0" : "infinity")("power", it.power)("coefficient", it.coefficient);
  f("formula", it.formula)("definitions", it.definitions).page("low", it.low);
}

void fields(Fields& f, const validation::ResonanceMark& it) {
  f("angular_frequency", it.omega)("kind", it.resonance ? "resonance" : "antiresonance");
}

void fields(Fields& f, const validation::FrequencyResponse& it) {
  f("points", it.points)("asymptotes", it.asymptotes)("extremes", it.marks);
}

void fields(Fields& f, const validation::FrictionCurve& it) {
  f("name", it.name)("own", it.own)("velocity_ratio", it.ratios)("friction_ratio", it.friction);
}

namespace {

Json state_map(const validation::StateMap& map, const char* rows_are) {
  const Fields f(Reader::file);
  Json rows = Json::array();
  auto cell = map.motions.begin();
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    const auto end = cell + static_cast<std::ptrdiff_t>(map.phases.size());
    rows.push_back(f.written(std::vector(cell, end)));
    cell = end;
  }
  return {{rows_are, map.rows}, {"phase", map.phases}, {"states", std::move(rows)}};
}

// "+0.2871"; what would be printed as zero has no sign.
std::string shown(double difference) {
  const std::string text = fmt::format("{:+.3f}", difference);
  return text.find_first_not_of("+-0.") == text.npos ? "0" : text;
}

/// A row for each delta; the wash behind a number is darkest from 0.3 on.
Json heat_rows(const validation::ReducedModel& model) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < model.table.deltas.size(); ++i) {
    Json cells = Json::array();
    for (const validation::ReducedAndFull& pair : model.table.rows[i])
      cells.push_back({{"heat", 100 * std::min(std::abs(pair.difference()) / 0.3, 1.0)},
                       {"words", shown(pair.difference())}});
    const double delta = model.table.deltas[i];
    rows.push_back({{"row_delta", delta}, {"own", delta == model.delta}, {"cells", cells}});
  }
  return rows;
}

const char* found_by(bool closed_form) { return closed_form ? "formula" : "simulation"; }

}  // namespace

void fields(Fields& f, const validation::Indented& it) {
  Json map = state_map(it.map, "place");
  map["velocity_ratio"] = it.map_ratio;
  f("critical_velocity_by", found_by(it.closed_form))("critical_velocity", it.critical_velocity);
  f("contact_radius", it.radius)("largest_contact_radius", it.edge);
  f("mean_normal_force", it.normal_force)("amplitudes", it.amplitudes)("shapes", it.shapes);
  f("state_map", map).page("by_formula", it.closed_form);
  if (f.for_page()) f("figures", report::indenter_figures(it));
}

void fields(Fields& f, const validation::Separation& it) {
  f("opens", it.opens)("critical_velocity_by", found_by(it.closed_form));
  f("critical_velocity", it.critical_velocity)("border", it.border)("derivation", it.derivation);
  f("curves", it.curves)("state_map", state_map(it.map, "velocity_ratio"));
  f.page("by_formula", it.closed_form).page("none", std::isinf(it.critical_velocity));
  if (!f.for_page()) return;
  std::vector<validation::figures::Figure> figures;
  if (!it.curves.empty()) figures.push_back(report::amplitude_figure(it));
  figures.push_back(report::state_figure(it));
  f("figures", figures);
}

void fields(Fields& f, const validation::ReducedModel& it) {
  Json table = Json::array();
  for (std::size_t i = 0; i < it.table.deltas.size(); ++i)
    for (std::size_t j = 0; j < it.table.ratios.size(); ++j)
      table.push_back({{"delta", it.table.deltas[i]},
                       {"velocity_ratio", it.table.ratios[j]},
                       {"reduced", f.written(it.table.rows[i][j].reduced)},
                       {"full", f.written(it.table.rows[i][j].full)}});
  f("delta", it.delta)("normal_force_amplitude_ratio", it.table.a)("tolerance", it.tolerance);
  f("usable_from", it.usable_from)("table", table);
  // The least speed at which it was tried is 0.01 v*.
  const bool everywhere = it.usable_from && *it.usable_from < 0.015;
  f.page("usable_everywhere", everywhere).page("by_delta", heat_rows(it));
  f.page("velocity_ratios", it.table.ratios);
}

namespace {

std::vector<std::string> failing(const SceneReport& report) {
  std::vector<std::string> keys;
  for (const validation::Comparison& comparison : report.comparisons)
    if (outcome(comparison) == validation::Comparison::Outcome::failed)
      keys.push_back(comparison.key);
  return keys;
}

}  // namespace

namespace {

std::vector<std::string> names_of_failed(const SceneReport& report) {
  std::vector<std::string> names;
  for (const validation::Comparison& comparison : report.comparisons)
    if (outcome(comparison) == validation::Comparison::Outcome::failed)
      names.emplace_back(report::claim_of(comparison).words);
  return names;
}

}  // namespace

/// v* of a scene and what is said of it.
struct VelocityOfScene {
  const SceneReport& report;
};

namespace {

// By more than the last digits that anyone reads.
bool doubles_differ(const SceneReport& report) {
  constexpr double worth_a_word = 1e-12;
  const double a = report.critical_velocity, b = report.velocity_of_doubles;
  return a != b && !(std::abs(a - b) <= worth_a_word * std::min(std::abs(a), std::abs(b)));
}

}  // namespace

void fields(Fields& f, const VelocityOfScene& it) {
  const SceneReport& report = it.report;
  const bool swings = !report.free_harmonics.empty(), creeps = report.creep_velocity > 0;
  f("value", report.critical_velocity)("relative_error_bound", report.relative_error_bound);
  f("condition_number", report.condition).some("reason", report.infinite_reason);
  f.when(doubles_differ(report), "of_doubles", report.velocity_of_doubles);
  const bool known = swings && !std::isnan(report.sliding_from);
  f.when(known, "sliding_from", report.sliding_from).some("free_harmonics", report.free_harmonics);
  f.when(creeps, "creep_velocity", report.creep_velocity);
  f.when(creeps, "drive_velocity", report.critical_velocity + report.creep_velocity);
  f.page("doubles_differ", doubles_differ(report))
      .page("several_swings", report.free_harmonics.size() > 1)
      .page("border_known", known);
  f.page("twice_the_harmonic", swings ? 2 * report.free_harmonics.front() : 0);
}

namespace {

void results(Fields& f, const report::SceneContents& contents) {
  const SceneReport& report = contents.report;
  f("admissible", report.reasons.empty())("reasons", report.reasons);
  f("critical_velocity", VelocityOfScene{report})("values", report.values);
  f.some("influences", report.influences).some("normal_force", report.normal_force);
  f("formula", report.formula.formula)("equation", report.equation);
  f("definitions", report.formula.definitions).page("real_formula", report.formula.is_real);
  f.page("ratio", present_markup(report.formula.ratio_markup));
  f("facts", report.facts);
  f("derivation", report.derivation)("limits", report.limits).some("compiler", report.compiler);
  f.some("friction_curve", report.curve).some("methods", report.methods);
  f.when(!report.response.points.empty(), "frequency_response", report.response);
  f.some("cycle", report.cycle).some("separation", report.separation);
  f.some("indenter", report.indented).some("reduced_model", report.reduced_model);
  f.some("accuracy", contents.accuracy);
}

/// Pictures of what stands in more than one part of the record.
void pictures(Fields& f, const SceneReport& scene) {
  const bool simulated = !scene.curve.empty();
  std::vector<validation::figures::Figure> friction, cycle;
  if (simulated) friction.push_back(report::friction_figure(scene));
  if (simulated && !scene.methods.empty()) friction.push_back(report::residual_figure(scene));
  if (scene.cycle) cycle = {report::force_figure(scene), report::velocity_figure(scene)};
  f("friction_figures", friction)("cycle_figures", cycle);
  f("answer_figure", report::answer_figure(scene));
  f("opening_figure", scene.reasons.empty() ? std::nullopt : report::opening_figure(scene));
  f("velocity_figure", report::frequency_figure(scene));
  f("stiffness_figure", report::stiffness_figure(scene));
}

}  // namespace

/// More are folded, so that what comes after them is seen.
constexpr std::size_t most_limits = 4;
/// A drawing of the system that is wider has a row of its own: beside the chart there are 418
/// pixels, in which its words would be smaller than 11.
constexpr double widest_beside = 530;  // px

void fields(Fields& f, const report::SceneContents& contents) {
  const SceneReport& scene = contents.report;
  f("file", scene.problem->source->file)("title", scene.problem->source->title)("passed",
                                                                                passed(scene));
  f("failed", failing(scene))("warnings", scene.problem->source->warnings);
  f("comparisons", scene.comparisons);
  if (scene.failure.empty()) results(f, contents);
  if (!scene.failure.empty() && scene.effect)
    f("effect", *scene.effect).some("friction_curve", scene.curve);
  f("text", scene.problem->source->text).page("failure", scene.failure);
  if (!f.for_page()) return;
  const bool outside = !scene.reasons.empty();
  f("heading", report::title_of(scene))("state", report::state_class(scene))("outside", outside);
  f("state_words", report::state_words(scene))("velocity_words", report::velocity_words(scene));
  f("tightest", report::unbroken(report::tightest_words(scene.comparisons)));
  f("reasons", scene.reasons);
  f("formula_applies", scene.formula_applies && !outside);
  f("simulated", !scene.curve.empty() || scene.indented.has_value());
  const report::Picture system = report::draw_system(scene.problem);
  f("system", system)("wide_system", system.drawing.width > widest_beside)
      .when(scene.effect.has_value(), "answer",
            scene.effect ? report::answer_record(scene) : Json());
  f("sentence", report::unbroken(report::sentence_of(scene)));
  f("checks", report::unbroken(report::checks_words(scene)));
  f("failed_names", names_of_failed(scene))("failed_warning", report::warning_of_failed(scene));
  f("speed_axis", report::speed_axis(scene));
  f("explorer", scene.failure.empty() ? report::explorer_record(scene.problem) : Json());
  f("many_limits", scene.limits.size() > most_limits);
  std::vector<validation::MethodCurve> silent;
  for (const validation::MethodCurve& method : scene.methods)
    if (std::any_of(method.points.begin(), method.points.end(),
                    [](const auto& point) { return !point.reason.empty(); }))
      silent.push_back(method);
  f("silent_methods", silent);
  pictures(f, scene);
}

}  // namespace vcrit::record
