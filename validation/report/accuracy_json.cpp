#include "report/accuracy_json.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

using accuracy::Accuracy;
using accuracy::EvaluatorError;
using accuracy::EvaluatorErrors;
using accuracy::Histogram;
using accuracy::Layer;
using accuracy::Solve;
using accuracy::SpeedSolves;
using accuracy::StabilityMap;
using accuracy::WorstInput;
using nlohmann::ordered_json;

/// Exact, whoever reads it.
std::string hexadecimal(double value) { return fmt::format("{:a}", value); }

ordered_json histogram_json(const Histogram& histogram) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < Histogram::size; ++i)
    if (histogram.counts[i] > 0) last = i;
  ordered_json counts = ordered_json::array();
  for (std::size_t i = 0; i <= last; ++i)
    counts.push_back({{"up_to", json_number(Histogram::upper(i))}, {"sets", histogram.counts[i]}});
  return {{"counts", counts}, {"not_finite", histogram.not_finite}};
}

ordered_json worst_input_json(const WorstInput& input, const std::vector<Symbol>& symbols) {
  ordered_json parameters = ordered_json::object();
  for (std::size_t i = 0; i < symbols.size(); ++i)
    parameters[to_text(symbols[i])] = hexadecimal(input.set[i]);
  return {{"parameters", parameters},
          {"found", hexadecimal(input.found)},
          {"right", hexadecimal(input.right)},
          {"error", json_number(input.error)}};
}

ordered_json evaluator_json(const EvaluatorError& way, const std::vector<Symbol>& symbols) {
  ordered_json object{{"key", way.key}, {"name", way.name}};
  if (!way.failure.empty()) object["failure"] = way.failure;
  if (!way.measured) return object;
  object["nanoseconds"] = way.nanoseconds;
  object["worst"] = json_number(way.worst);
  object["rms"] = json_number(way.rms);
  object["on_front"] = way.on_front;
  object["histogram"] = histogram_json(way.histogram);
  object["worst_inputs"] = ordered_json::array();
  for (const WorstInput& input : way.worst_inputs)
    object["worst_inputs"].push_back(worst_input_json(input, symbols));
  return object;
}

ordered_json evaluators_json(const EvaluatorErrors& errors) {
  ordered_json object{{"seed", errors.seed}, {"sets", errors.sets}};
  if (errors.near_resonance > 0) object["near_resonance"] = errors.near_resonance;
  if (errors.near_antiresonance > 0) object["near_antiresonance"] = errors.near_antiresonance;
  if (!errors.compiler.empty()) object["compiler"] = errors.compiler;
  object["ways"] = ordered_json::array();
  for (const EvaluatorError& way : errors.ways)
    object["ways"].push_back(evaluator_json(way, errors.symbols));
  return object;
}

ordered_json solve_json(const Solve& solve) {
  ordered_json object{{"method", solve.method}, {"setting", solve.setting}};
  if (!solve.failure.empty()) object["failure"] = solve.failure;
  if (!solve.answered) return object;
  object["seconds"] = solve.seconds;
  object["friction_ratio"] = json_number(solve.friction_ratio);
  object["error"] = json_number(solve.error);
  object["on_front"] = solve.on_front;
  return object;
}

ordered_json speed_json(const SpeedSolves& speed) {
  ordered_json object{{"velocity_ratio", speed.ratio},
                      {"friction_ratio", json_number(speed.friction_ratio)},
                      {"reference", speed.reference}};
  if (speed.agreement) object["agreement"] = json_number(*speed.agreement);
  object["solves"] = ordered_json::array();
  for (const Solve& solve : speed.solves) object["solves"].push_back(solve_json(solve));
  return object;
}

ordered_json layer_json(const Layer& layer) {
  ordered_json object{{"key", layer.key}, {"name", layer.name}};
  object["digits_lost"] = ordered_json::array();
  for (const double lost : layer.lost) object["digits_lost"].push_back(json_number(lost));
  object["marks"] = ordered_json::array();
  for (const accuracy::Mark& mark : layer.marks)
    object["marks"].push_back(
        {{"angular_frequency", mark.omega}, {"factor", mark.factor}, {"words", mark.words}});
  return object;
}

ordered_json map_json(const StabilityMap& map) {
  ordered_json object{{"key", map.key}};
  for (const Symbol& symbol : map.scaled) object["scaled"].push_back(to_text(symbol));
  object["angular_frequency"] = map.omega;
  object["factor"] = map.factor;
  object["layers"] = ordered_json::array();
  for (const Layer& layer : map.layers) object["layers"].push_back(layer_json(layer));
  for (const accuracy::Line& line : map.lines)
    object["lines"].push_back({{"name", line.name}, {"points", line.points}});
  return object;
}

}  // namespace

ordered_json accuracy_json(const Accuracy& accuracy) {
  ordered_json object{{"command", accuracy.command},
                      {"evaluators", evaluators_json(accuracy.evaluators)}};
  for (const SpeedSolves& speed : accuracy.simulators)
    object["simulators"].push_back(speed_json(speed));
  for (const StabilityMap& map : accuracy.maps) object["maps"].push_back(map_json(map));
  if (!accuracy.left_out.empty()) object["left_out"] = accuracy.left_out;
  return object;
}

}  // namespace vcrit::validation::report
