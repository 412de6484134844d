// What one scene's accuracy, cost and stability say of themselves (records.hpp).
#include <fmt/core.h>

#include <algorithm>

#include "accuracy/pictures.hpp"
#include "report/records.hpp"

namespace vcrit::record {

namespace accuracy = validation::accuracy;
using validation::figures::Figure;

namespace {

/// Exact, whoever reads it.
std::string hexadecimal(double value) { return fmt::format("{:a}", value); }

}  // namespace

/// What was not ranked, and why.
struct NotRanked {
  std::string what, why;
};

void fields(Fields& f, const NotRanked& it) { f("what", it.what)("why", it.why); }

void fields(Fields& f, const accuracy::Histogram& it) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < accuracy::Histogram::size; ++i)
    if (it.counts[i] > 0) last = i;
  Json counts = Json::array();
  for (std::size_t i = 0; i <= last; ++i)
    counts.push_back({{"up_to", f.written(accuracy::Histogram::upper(i))}, {"sets", it.counts[i]}});
  f("counts", counts)("not_finite", it.not_finite);
}

namespace {

/// More would make the page twice as long for a hundred branches.
constexpr std::size_t most_parameters = 32;

std::string inputs(const Json& parameters) {
  std::string text;
  std::size_t shown = 0;
  for (const auto& [name, value] : parameters.items()) {
    if (++shown > most_parameters) return text + ", … (all in report.json)";
    text += (text.empty() ? "" : ", ") + name + " = " + value.get<std::string>();
  }
  return text;
}

}  // namespace

struct NamedInput {
  const accuracy::WorstInput& input;
  const std::vector<Symbol>& symbols;
};

void fields(Fields& f, const NamedInput& it) {
  Json parameters = Json::object();
  for (std::size_t i = 0; i < it.symbols.size(); ++i)
    parameters[to_text(it.symbols[i])] = hexadecimal(it.input.set[i]);
  f("parameters", parameters)("found", hexadecimal(it.input.found));
  f("right", hexadecimal(it.input.right))("error", it.input.error);
  f.page("inputs", inputs(parameters));
}

struct NamedWay {
  const accuracy::EvaluatorError& way;
  const std::vector<Symbol>& symbols;
};

void fields(Fields& f, const NamedWay& it) {
  const accuracy::EvaluatorError& way = it.way;
  std::vector<NamedInput> worst;
  for (const accuracy::WorstInput& input : way.worst_inputs) worst.push_back({input, it.symbols});
  f("key", way.key)("name", way.name).some("failure", way.failure).page("measured", way.measured);
  if (!way.measured) return;
  f("nanoseconds", way.nanoseconds)("worst", way.worst)("rms", way.rms);
  f("on_front", way.on_front)("histogram", way.histogram)("worst_inputs", worst);
}

void fields(Fields& f, const accuracy::EvaluatorErrors& it) {
  f("seed", it.seed)("sets", it.sets);
  f.when(it.near_resonance > 0, "near_resonance", it.near_resonance);
  f.when(it.near_antiresonance > 0, "near_antiresonance", it.near_antiresonance);
  std::vector<NamedWay> ways, measured, with_worst;
  std::vector<NotRanked> not_ranked;
  for (const accuracy::EvaluatorError& way : it.ways) {
    ways.push_back({way, it.symbols});
    if (way.measured && !way.worst_inputs.empty()) with_worst.push_back({way, it.symbols});
    if (way.measured) measured.push_back({way, it.symbols});
    if (!way.failure.empty()) not_ranked.push_back({way.name, way.failure});
  }
  f.some("compiler", it.compiler)("ways", ways).page("not_ranked", not_ranked);
  f.page("measured_ways", measured).page("with_worst", with_worst);
  if (f.for_page())
    f("figures",
      std::vector<Figure>{accuracy::evaluator_picture(it), accuracy::histogram_picture(it)});
}

void fields(Fields& f, const accuracy::Solve& it) {
  f("method", it.method)("setting", it.setting).some("failure", it.failure);
  f.page("answered", it.answered);
  if (!it.answered) return;
  f("seconds", it.seconds)("friction_ratio", it.friction_ratio)("error", it.error);
  f("on_front", it.on_front);
}

void fields(Fields& f, const accuracy::SpeedSolves& it) {
  f("velocity_ratio", it.ratio)("friction_ratio", it.friction_ratio)("reference", it.reference);
  f.some("agreement", it.agreement)("solves", it.solves);
}

void fields(Fields& f, const accuracy::Mark& it) {
  f("angular_frequency", it.omega)("factor", it.factor)("words", it.words);
}

void fields(Fields& f, const accuracy::Layer& it) {
  f("key", it.key)("name", it.name)("digits_lost", it.lost)("marks", it.marks);
}

void fields(Fields& f, const accuracy::MapLine& it) { f("name", it.name)("points", it.points); }

namespace {

/// Nothing to see: less than a digit is lost wherever there is an answer, and nothing went wrong.
bool is_flat(const accuracy::Layer& layer) {
  return std::all_of(layer.lost.begin(), layer.lost.end(), [](double lost) { return lost < 1; }) &&
         layer.marks.empty();
}

}  // namespace

void fields(Fields& f, const accuracy::StabilityMap& it) {
  std::vector<std::string> scaled;
  for (const Symbol& symbol : it.scaled) scaled.push_back(to_text(symbol));
  f("key", it.key).some("scaled", scaled)("angular_frequency", it.omega)("factor", it.factor);
  f("layers", it.layers).some("lines", it.lines).page("over_stiffness", it.key == "stiffness");
  if (!f.for_page()) return;
  std::vector<Figure> figures;
  std::vector<std::string> flat;
  for (const accuracy::Layer& layer : it.layers)
    if (is_flat(layer))
      flat.push_back(layer.name);
    else
      figures.push_back(accuracy::map_picture(it, layer));
  f("figures", figures)("flat", flat)("cells", it.omega.size() * it.factor.size());
  f.when(!figures.empty(), "about", accuracy::about_maps(it));
}

namespace {

std::vector<NotRanked> not_ranked(const std::vector<accuracy::SpeedSolves>& speeds) {
  std::vector<NotRanked> all;
  for (const accuracy::SpeedSolves& speed : speeds)
    for (const accuracy::Solve& solve : speed.solves)
      if (!solve.failure.empty())
        all.push_back(
            {fmt::format("{} {} at {}", solve.method, solve.setting, speed.ratio), solve.failure});
  return all;
}

}  // namespace

void fields(Fields& f, const accuracy::Accuracy& it) {
  f("command", it.command)("evaluators", it.evaluators).some("simulators", it.simulators);
  f.some("maps", it.maps).some("left_out", it.left_out);
  if (!f.for_page()) return;
  std::vector<Figure> figures;
  for (const accuracy::SpeedSolves& speed : it.simulators)
    figures.push_back(accuracy::simulator_picture(speed));
  const Json simulated{{"figures", f.written(figures)},
                       {"not_ranked", f.written(not_ranked(it.simulators))}};
  f.when(!it.simulators.empty(), "simulated_accuracy", simulated);
}

}  // namespace vcrit::record
