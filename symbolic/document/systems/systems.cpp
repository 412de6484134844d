// The table of systems, and how a formula becomes a document of one.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "base/plain_text.hpp"
#include "document/print.hpp"
#include "document/systems/names.hpp"
#include "document/systems/system.hpp"
#include "document/systems/system_dialect.hpp"
#include "document/systems/taken.hpp"
#include "formula/names.hpp"
#include "record/fields.hpp"
#include "record/template.hpp"

extern "C" const char vcrit_system_templates[], vcrit_system_templates_end[];

namespace vcrit::symbolic {

extern const AlgebraSystem sympy, mathematica, maple, maxima, mathml, c_language;

namespace {

using record::Fields, record::Json;

// As many characters are printed in a few seconds.
constexpr std::size_t most_characters_of_system = 10'000'000;

/// With absolute values of complex numbers called so, and their powers as products where the
/// system has none.
Form typed(Form form, const Syntax& syntax, const std::vector<std::string>& complex) {
  for (Form& each : form.over) each = typed(std::move(each), syntax, complex);
  for (Form& each : form.under) each = typed(std::move(each), syntax, complex);
  if (form.kind == Form::Kind::call && may_be_complex(form.terms[0].form, complex))
    form.text = "cabs";
  for (Signed& each : form.terms) each.form = typed(std::move(each.form), syntax, complex);
  if (form.kind != Form::Kind::power || syntax.power_of_complex || !may_be_complex(form, complex))
    return form;
  const auto factors = static_cast<std::size_t>(form.exponent);
  return {Form::Kind::product, "", std::vector<Form>(factors, form.over[0]), {}, {}, 1};
}

/// Symbols and formulas of one document as the system writes them.
class Writer {
 public:
  Writer(const AlgebraSystem& system, const TakenFormula& formula)
      : system_(system), names_(system, formula) {
    for (const TakenParameter& each : formula.parameters)
      if (each.range == TakenParameter::Domain::complex) complex_.push_back(each.symbol);
    for (const TakenDefinition& each : formula.definitions)
      if (each.complex) complex_.push_back(each.symbol);
  }

  record::Markup symbol(const std::string& symbol) const {
    return written({Form::Kind::name, symbol, {}, {}, {}, 1});
  }

  record::Markup written(const Form& form) const {
    if (system_.syntax == nullptr) return {mathml_dialect().print({false, form})};
    const SystemDialect dialect(*system_.syntax, names_);
    return {dialect.print({false, typed(form, *system_.syntax, complex_)})};
  }

  bool any_complex() const { return !complex_.empty(); }

 private:
  const AlgebraSystem& system_;
  SystemNames names_;
  std::vector<std::string> complex_;
};

Json parameter_record(const TakenParameter& parameter, const Writer& writer) {
  using Domain = TakenParameter::Domain;
  const record::Markup symbol = writer.symbol(parameter.symbol);
  const std::string scene = printed_name(parameter.symbol);
  Fields f(record::Reader::page);
  f("symbol", symbol)("scene", scene)("changed", symbol.text != scene);
  f("meaning", parameter.meaning)("unit", parameter.unit);
  f("positive", parameter.range == Domain::positive)("poisson", parameter.range == Domain::poisson)(
      "complex", parameter.range == Domain::complex);
  return f.take();
}

Json definition_record(const TakenDefinition& definition, const Writer& writer) {
  Fields f(record::Reader::page);
  f("symbol", writer.symbol(definition.symbol))("meaning", writer.written(definition.meaning));
  f("complex", definition.complex);
  return f.take();
}

Json formula_record(const AlgebraSystem& system, const Problem& problem, const Findings& findings) {
  const TakenFormula formula = taken_formula(problem, findings);
  const Writer writer(system, formula);
  Json parameters = Json::array(), definitions = Json::array();
  for (const TakenParameter& each : formula.parameters)
    parameters.push_back(parameter_record(each, writer));
  for (const TakenDefinition& each : formula.definitions)
    definitions.push_back(definition_record(each, writer));
  Fields f(record::Reader::page);
  f("title", title_of(problem))("notes", formula.notes)("equation", findings.derivation.equation);
  f("fingerprint", findings.fingerprint)("result", std::string(system.result));
  f("parameters", parameters)("definitions", definitions);
  f("velocity", writer.written(formula.velocity))("complex", writer.any_complex());
  return f.take();
}

const AlgebraSystem& system_of(const std::string& name) {
  for (const AlgebraSystem* system : systems())
    if (system->name == name) return *system;
  throw InputError(argument("format"), '"' + name + '"',
                   fmt::format("one of {}", joined(system_names(), ", ")));
}

}  // namespace

const std::vector<const AlgebraSystem*>& systems() {
  static const std::vector<const AlgebraSystem*> all{&sympy,  &mathematica, &maple,
                                                     &maxima, &mathml,      &c_language};
  return all;
}

const std::vector<std::string>& system_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const AlgebraSystem* system : systems()) all.emplace_back(system->name);
    return all;
  }();
  return names;
}

std::string exact_number(const std::string& digits) { return digits; }

std::string in_comment(std::string_view text) {
  std::string out;
  for (const char c : one_line(text)) {
    const bool ends = !out.empty() && std::string_view("*/()-").find(c) != std::string_view::npos &&
                      std::string_view("*/(-").find(out.back()) != std::string_view::npos;
    const bool trigraph = out.ends_with("??");
    if (ends || trigraph) out += ' ';
    out += c == '\\' ? ' ' : c;
  }
  return out;
}

std::string system_document(const std::string& name, const Problem& problem,
                            const Findings& findings) {
  const AlgebraSystem& system = system_of(name);
  const record::Templates templates(
      {vcrit_system_templates,
       static_cast<std::size_t>(vcrit_system_templates_end - vcrit_system_templates)},
      system.escape);
  std::string text =
      templates.render(std::string(system.name), formula_record(system, problem, findings));
  if (text.size() > most_characters_of_system)
    throw ModelError(fmt::format("for {} v* takes {:.2g} MB of text, more than {:.2g}", name,
                                 1e-6 * static_cast<double>(text.size()),
                                 1e-6 * static_cast<double>(most_characters_of_system)),
                     "`form nested` is shorter, and `format text` what people read");
  return text + "\n";
}

}  // namespace vcrit::symbolic
