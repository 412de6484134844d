#include "document/json.hpp"

#include <nlohmann/json.hpp>

#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/text.hpp"

namespace vcrit::symbolic {

namespace {

using Json = nlohmann::ordered_json;

Json formula(const GiNaC::ex& expression) {
  return {{"text", to_text(expression)}, {"latex", to_latex(expression)}};
}

Json condition(const GiNaC::ex& expression) {
  return {{"text", text_dialect().equation(form_of(expression), form_of(0))},
          {"latex", latex_dialect().equation(form_of(expression), form_of(0))}};
}

Json json_lines(const std::vector<Line>& all) {
  Json out = Json::array();
  for (const Line& line : all) {
    const Signed left = form_of(line.left), right = form_of(line.right);
    out.push_back({{"words", line.words},
                   {"text", text_dialect().equation(left, right)},
                   {"latex", latex_dialect().equation(left, right)}});
  }
  return out;
}

Json json(const Limit& limit) {
  return {{"name", limit.name},
          {"equation", limit.equation},
          {"text", to_text(limit.result)},
          {"latex", to_latex(limit.result)},
          {"definitions", json_lines(limit.definitions)}};
}

Json json(const Asymptote& asymptote) {
  return {{"name", asymptote.name},
          {"power", asymptote.power},
          {"coefficient", formula(asymptote.coefficient)},
          {"definitions", json_lines(asymptote.definitions)}};
}

Json json(const Resonance& resonance) {
  const bool infinite = resonance.kind == Resonance::Kind::resonance;
  Json out{{"name", infinite ? "resonance" : "antiresonance"},
           {"condition", condition(resonance.condition)},
           {"damped", resonance.damped},
           {"frequency", resonance.frequency ? formula(*resonance.frequency) : Json()},
           {"real_part", Json()},
           {"imaginary_part", Json()},
           {"definitions", json_lines(resonance.definitions)}};
  if (!resonance.parts) return out;
  out["real_part"] = condition(resonance.parts->real);
  out["imaginary_part"] = condition(resonance.parts->imaginary);
  return out;
}

Json json(const Sensitivity& sensitivity) {
  std::vector<Line> definitions = sensitivity.stiffnesses;
  definitions.insert(definitions.end(), sensitivity.changes.begin(), sensitivity.changes.end());
  return {{"parameter", printed_name(to_text(sensitivity.parameter))},
          {"relative", formula(sensitivity.relative)},
          {"derivative", formula(sensitivity.derivative)},
          {"definitions", json_lines(definitions)}};
}

template <class Finding>
Json list(const std::vector<Finding>& all) {
  Json out = Json::array();
  for (const Finding& each : all) out.push_back(json(each));
  return out;
}

Json json_names(const std::vector<Symbol>& symbols) {
  Json out = Json::array();
  for (const Symbol& symbol : symbols) out.push_back(printed_name(to_text(symbol)));
  return out;
}

}  // namespace

std::string json_document(const Scene& scene, const Findings& findings) {
  const Derivation& d = findings.derivation;
  Json out{{"title", scene.title},
           {"form", d.definitions.empty() ? "multiplied out" : "nested"},
           {"fingerprint", findings.fingerprint},
           {"lines", json_lines(d.lines)},
           {"parameters", json_names(d.parameters)},
           {"equation", d.equation},
           {"critical_velocity", formula(d.critical_velocity)},
           {"definitions", json_lines(d.definitions)},
           {"limits", list(findings.limits)},
           {"asymptotes", list(findings.asymptotes)},
           {"resonances", list(findings.resonances)},
           {"sensitivities", list(findings.sensitivities)}};
  if (!scene.warnings.empty()) out["warnings"] = scene.warnings;
  if (!findings.half_space.empty()) out["indenter"] = json_lines(findings.half_space);
  if (findings.parting)
    out["separation"] = {{"closed_form", !findings.parting->empty()},
                         {"lines", json_lines(*findings.parting)}};
  if (findings.parting && findings.parting->empty() && !findings.beyond_simulation.empty())
    out["separation"]["not_simulated"] = findings.beyond_simulation;
  if (!findings.extrema.empty()) out["extrema"] = json_lines(findings.extrema);
  if (!findings.form_lines.empty())
    out[findings.form == ResultForm::rational ? "rational" : "dimensionless"] =
        json_lines(findings.form_lines);
  return out.dump(2) + "\n";
}

}  // namespace vcrit::symbolic
