#include "document/json.hpp"

#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/text.hpp"
#include "record/fields.hpp"
#include "record/json_text.hpp"

// A formula or an equation is its text and its LaTeX.
namespace vcrit::record {

namespace symbolic = vcrit::symbolic;

struct DerivedFormula {
  const GiNaC::ex& expression;
};

void fields(Fields& f, const DerivedFormula& it) {
  f("text", symbolic::to_text(it.expression))("latex", symbolic::to_latex(it.expression));
}

struct DerivedEquation {
  const GiNaC::ex& left;
  const GiNaC::ex right;
};

void fields(Fields& f, const DerivedEquation& it) {
  const auto left = symbolic::form_of(it.left), right = symbolic::form_of(it.right);
  f("text", symbolic::text_dialect().equation(left, right));
  f("latex", symbolic::latex_dialect().equation(left, right));
}

namespace {

std::optional<DerivedEquation> zero(const GiNaC::ex* expression) {
  if (expression == nullptr) return std::nullopt;
  return DerivedEquation{*expression, 0};
}

}  // namespace

void fields(Fields& f, const symbolic::Line& it) {
  f("words", it.words.text());
  fields(f, DerivedEquation{it.left, it.right});
}

void fields(Fields& f, const symbolic::Limit& it) {
  f("name", it.name)("equation", it.equation);
  fields(f, DerivedFormula{it.result});
  f("definitions", it.definitions);
}

void fields(Fields& f, const symbolic::Asymptote& it) {
  f("name", it.name)("power", it.power)("coefficient", DerivedFormula{it.coefficient});
  f("definitions", it.definitions);
}

void fields(Fields& f, const symbolic::Resonance& it) {
  using Kind = symbolic::Resonance::Kind;
  const char* name = it.kind == Kind::resonance       ? "resonance"
                     : it.kind == Kind::antiresonance ? "antiresonance"
                                                      : "mount_resonance";
  f("name", name)("condition", DerivedEquation{it.condition, 0});
  f("damped", it.damped);
  if (it.frequency)
    f("frequency", DerivedFormula{*it.frequency});
  else
    f("frequency", nullptr);
  f("real_part", zero(it.parts ? &it.parts->real : nullptr));
  f("imaginary_part", zero(it.parts ? &it.parts->imaginary : nullptr));
  f("definitions", it.definitions);
}

void fields(Fields& f, const symbolic::Sensitivity& it) {
  std::vector<symbolic::Line> definitions = it.stiffnesses;
  definitions.insert(definitions.end(), it.changes.begin(), it.changes.end());
  f("parameter", symbolic::printed_name(to_text(it.parameter)))("relative",
                                                                DerivedFormula{it.relative});
  f("derivative", DerivedFormula{it.derivative})("definitions", definitions);
}

void fields(Fields& f, const symbolic::ShortestForm::Definition& it) {
  const symbolic::Signed left{false, it.name}, right{false, it.meaning};
  f("text", symbolic::text_dialect().equation(left, right));
  f("latex", symbolic::latex_dialect().equation(left, right));
}

void fields(Fields& f, const symbolic::Fact& it) {
  f("key", it.key)("words", it.words.text())("lines", it.lines);
}

struct DerivedSeparation {
  const std::vector<symbolic::Line>& lines;
  const std::string& beyond_simulation;
};

void fields(Fields& f, const DerivedSeparation& it) {
  f("closed_form", !it.lines.empty())("lines", it.lines);
  if (it.lines.empty()) f.some("not_simulated", it.beyond_simulation);
}

namespace {

std::vector<std::string> names_of(const std::vector<Symbol>& symbols) {
  std::vector<std::string> names;
  for (const Symbol& symbol : symbols) names.push_back(symbolic::printed_name(to_text(symbol)));
  return names;
}

}  // namespace

/// An equation whose sides are forms.
struct WrittenEquation {
  std::string words;
  symbolic::Signed left, right;
};

void fields(Fields& f, const WrittenEquation& it) {
  f("words", it.words);
  f("text", symbolic::text_dialect().equation(it.left, it.right));
  f("latex", symbolic::latex_dialect().equation(it.left, it.right));
}

struct WrittenFormula {
  const symbolic::Form& form;
};

void fields(Fields& f, const WrittenFormula& it) {
  f("text", symbolic::text_dialect().print({false, it.form}));
  f("latex", symbolic::latex_dialect().print({false, it.form}));
}

namespace {

std::vector<WrittenEquation> written(const std::vector<symbolic::Line>& lines) {
  std::vector<WrittenEquation> result;
  for (const symbolic::Line& line : lines)
    result.push_back(
        {line.words.text(), symbolic::form_of(line.left), symbolic::form_of(line.right)});
  return result;
}

/// The derivation's lines, the last with the result as it is shown, and what defines its names.
struct PrintedResult {
  std::string form;
  std::vector<WrittenEquation> lines, definitions;
};

PrintedResult printed_result(const symbolic::Findings& findings) {
  const symbolic::Derivation& derivation = findings.derivation;
  const bool nested = !derivation.definitions.empty();
  PrintedResult result{nested ? "nested" : "multiplied out", written(derivation.lines), {}};
  if (findings.shortest) {
    result.form = findings.form == symbolic::ResultForm::storage_loss ? "storage-loss" : "shortest";
    result.lines.back().right = {false, findings.shortest->velocity};
    for (const auto& each : findings.shortest->definitions)
      result.definitions.push_back({"", {false, each.name}, {false, each.meaning}});
    // Limits and sensitivities are in complex stiffnesses, which are defined for these.
    if (findings.limits.empty() && findings.sensitivities.each.empty()) return result;
  }
  const auto complex = written(derivation.definitions);
  result.definitions.insert(result.definitions.end(), complex.begin(), complex.end());
  return result;
}

/// The lines of the form that was asked for, beside the result.
std::vector<WrittenEquation> form_equations(const symbolic::Findings& findings) {
  std::vector<WrittenEquation> result = written(findings.form_lines);
  if (!findings.in_groups) return result;
  for (const symbolic::Equation& each : symbolic::equations_of(*findings.in_groups))
    result.push_back({"", {false, each.left}, each.right});
  return result;
}

}  // namespace

struct DerivedDocument {
  Problem problem;
  const symbolic::Findings& findings;
};

void fields(Fields& f, const DerivedDocument& document) {
  const symbolic::Findings& it = document.findings;
  const symbolic::Derivation& d = it.derivation;
  const PrintedResult result = printed_result(it);
  const bool rational = it.form == symbolic::ResultForm::rational;
  f("title", document.problem->source->title);
  f("form", result.form)("fingerprint", it.fingerprint);
  f("lines", result.lines)("parameters", names_of(d.parameters))("equation", d.equation);
  if (it.shortest)
    f("critical_velocity", WrittenFormula{it.shortest->velocity});
  else
    f("critical_velocity", DerivedFormula{d.critical_velocity});
  f("definitions", result.definitions)("facts", it.facts);
  if (it.shortest) f("operations", it.shortest->operations);
  f("limits", it.limits)("asymptotes", it.asymptotes)("resonances", it.resonances);
  f("sensitivities", it.sensitivities.each);
  f.some("sensitivity_definitions", it.sensitivities.shared);
  f.some("warnings", document.problem->source->warnings);
  f.some("indenter", it.half_space);
  if (it.separation) f("separation", DerivedSeparation{*it.separation, it.beyond_simulation});
  f.some("extrema", it.extrema).some(rational ? "rational" : "dimensionless", form_equations(it));
}

}  // namespace vcrit::record

namespace vcrit::symbolic {

std::string json_document(const Problem& problem, const Findings& findings) {
  return record::json_text(record::json_of(record::DerivedDocument{problem, findings}), 2) + "\n";
}

}  // namespace vcrit::symbolic
