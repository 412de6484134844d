#include "document/systems/taken.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "base/errors.hpp"
#include "base/numbers.hpp"
#include "derivation/meanings.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

// Python's compiler, for one, goes as deep as a sum has terms, up to some thousand.
constexpr std::size_t most_terms_of_a_line = 400;

Form name_of(const std::string& symbol) { return {Form::Kind::name, symbol, {}, {}, {}, 1}; }

void for_each_name(const Form& form, const std::function<void(const std::string&)>& visit) {
  if (form.kind == Form::Kind::name) visit(form.text);
  for (const Form& each : form.over) for_each_name(each, visit);
  for (const Form& each : form.under) for_each_name(each, visit);
  for (const Signed& each : form.terms) for_each_name(each.form, visit);
}

/// A form with its sign inside.
Form plain_form(const GiNaC::ex& expression) {
  Signed form = form_of(expression);
  if (!form.minus) return std::move(form.form);
  return {Form::Kind::sum, "", {}, {}, {std::move(form)}, 1};
}

struct Named {
  std::string symbol;
  Form meaning;
};

/// v* and what it may be made of, in any order.
struct Written {
  std::vector<Named> definitions;
  Form velocity;
};

/// The line of v*, or of its square; the others are definitions.
Written written_in(const std::vector<Line>& lines) {
  const GiNaC::ex v = quantity("v*");
  Written result;
  for (const Line& line : lines) {
    if (line.left.is_equal(v)) {
      result.velocity = plain_form(line.right);
    } else if (line.left.has(v)) {
      const GiNaC::ex leading = symbol({"mu0"}) * omega() * symbol({"du_z"});
      result.velocity =
          plain_form(leading * GiNaC::sqrt(GiNaC::ex(line.right / (leading * leading))));
    } else {
      result.definitions.push_back({form_of(line.left).form.text, plain_form(line.right)});
    }
  }
  return result;
}

Written in_named_steps(const ShortestForm& form) {
  Written result{{}, form.velocity};
  for (const ShortestForm::Definition& each : form.definitions)
    result.definitions.push_back({each.name.text, each.meaning});
  return result;
}

Written written_form(const Findings& findings) {
  if (findings.in_groups) {
    Written result = in_named_steps(*findings.in_groups);
    for (const Line& group : findings.form_lines)
      result.definitions.push_back({form_of(group.left).form.text, plain_form(group.right)});
    return result;
  }
  if (!findings.form_lines.empty()) return written_in(findings.form_lines);
  if (findings.shortest) return in_named_steps(*findings.shortest);
  std::vector<Line> lines = findings.derivation.definitions;
  lines.push_back({"", laplace(), GiNaC::I * omega()});
  lines.push_back({"", quantity("v*"), findings.derivation.critical_velocity});
  return written_in(lines);
}

/// Puts what a formula needs in order, and finds what has no definition.
class Ordered {
 public:
  explicit Ordered(const Written& written) {
    for (const Named& each : written.definitions) meanings_[each.symbol] = &each.meaning;
    visit(written.velocity, needed_);
    for (const Named& each : written.definitions)
      if (needed_.contains(each.symbol)) place(each.symbol);
  }

  std::vector<Named> definitions;
  std::set<std::string> others;

 private:
  /// All names of a form, and of what it needs.
  void visit(const Form& form, std::set<std::string>& found) {
    for_each_name(form, [&](const std::string& name) {
      if (!found.insert(name).second) return;
      const auto meaning = meanings_.find(name);
      if (meaning != meanings_.end()) return visit(*meaning->second, found);
      if (name != own_name("i")) others.insert(name);
    });
  }

  void place(const std::string& symbol) {
    const auto meaning = meanings_.find(symbol);
    if (meaning == meanings_.end() || !placed_.insert(symbol).second) return;
    for_each_name(*meaning->second, [this](const std::string& name) { place(name); });
    definitions.push_back({symbol, *meaning->second});
  }

  std::map<std::string, const Form*> meanings_;
  std::set<std::string> needed_, placed_;
};

/// A sum in lines of its own where it is a long one.
void put_in_lines(Named definition, std::vector<Named>& lines) {
  std::vector<Signed>& terms = definition.meaning.terms;
  if (definition.meaning.kind != Form::Kind::sum || terms.size() <= most_terms_of_a_line)
    return lines.push_back(std::move(definition));
  Form whole{Form::Kind::sum, "", {}, {}, {}, 1};
  for (std::size_t from = 0; from < terms.size(); from += most_terms_of_a_line) {
    const std::size_t to = std::min(from + most_terms_of_a_line, terms.size());
    const auto at = [&](std::size_t i) { return terms.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::string part =
        own_name(fmt::format("{}_part_{}", base_name(definition.symbol), whole.terms.size() + 1));
    lines.push_back({part, {Form::Kind::sum, "", {}, {}, {at(from), at(to)}, 1}});
    whole.terms.push_back({false, name_of(part)});
  }
  lines.push_back({std::move(definition.symbol), std::move(whole)});
}

std::vector<TakenDefinition> definitions_of(const std::vector<Named>& ordered,
                                            std::vector<std::string> complex) {
  std::vector<Named> lines;
  for (const Named& each : ordered) put_in_lines(each, lines);
  std::vector<TakenDefinition> result;
  for (Named& each : lines) {
    const bool is = may_be_complex(each.meaning, complex);
    if (is) complex.push_back(each.symbol);
    result.push_back({std::move(each.symbol), std::move(each.meaning), is});
  }
  return result;
}

/// In the order of Derivation::parameters, then the receptance.
std::vector<TakenParameter> parameters_of(const Problem& problem, std::set<std::string> names) {
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  const std::string poisson = isotropic != nullptr && isotropic->by == Isotropic::By::poisson
                                  ? to_text(isotropic->quantity.symbol)
                                  : "";
  std::vector<Symbol> order{{"mu0"}, {"omega"}, {"du_z"}, {"m"}, {"m_n"}};
  if (isotropic != nullptr) order.push_back(isotropic->quantity.symbol);
  for (const Symbol& symbol : *problem->elements) order.push_back(symbol);
  const std::map<Symbol, Meaning> meanings = meanings_of(problem);
  using Domain = TakenParameter::Domain;
  std::vector<TakenParameter> result;
  for (const Symbol& symbol : order) {
    const std::string name = to_text(symbol);
    if (names.erase(name) == 0) continue;
    const Meaning& meaning = meanings.at(symbol);
    result.push_back({name, name == poisson ? Domain::poisson : Domain::positive, meaning.words,
                      si_unit(meaning.dimension)});
  }
  if (names.erase(own_name("R_d")) == 1)
    result.push_back({own_name("R_d"), Domain::complex,
                      "receptance of the drive at omega, complex, from its table", "m/N"});
  ensure(names.empty(), "a formula has parameters and definitions, and no other names");
  return result;
}

std::vector<std::string> notes_of(const Problem& problem, const Findings& findings) {
  std::vector<std::string> notes;
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic != nullptr && isotropic->quantity.value)
    notes.push_back(fmt::format(
        "{} {} is put in.",
        isotropic->by == Isotropic::By::poisson ? "Poisson's ratio" : "The ratio K_t/K_n =",
        to_text(*isotropic->quantity.value)));
  if (findings.separation && findings.separation->empty())
    notes.emplace_back(
        "It holds while the contact stays closed; where it opens v* is another one.");
  return notes;
}

}  // namespace

bool may_be_complex(const Form& form, const std::vector<std::string>& complex) {
  const auto any = [&](const std::vector<Form>& forms) {
    return std::any_of(forms.begin(), forms.end(),
                       [&](const Form& each) { return may_be_complex(each, complex); });
  };
  if (form.kind == Form::Kind::call) return false;  // the absolute value is the only one
  if (form.kind == Form::Kind::name)
    return form.text == own_name("i") ||
           std::find(complex.begin(), complex.end(), form.text) != complex.end();
  return any(form.over) || any(form.under) ||
         std::any_of(form.terms.begin(), form.terms.end(),
                     [&](const Signed& term) { return may_be_complex(term.form, complex); });
}

TakenFormula taken_formula(const Problem& problem, const Findings& findings) {
  const Written written = written_form(findings);
  const Ordered ordered(written);
  TakenFormula result{
      notes_of(problem, findings), parameters_of(problem, ordered.others), {}, written.velocity};
  result.definitions = definitions_of(ordered.definitions, {own_name("R_d")});
  return result;
}

}  // namespace vcrit::symbolic
