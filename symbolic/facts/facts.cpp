#include "facts/facts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/resonance.hpp"
#include "base/errors.hpp"
#include "derivation/loaded.hpp"
#include "derivation/model.hpp"
#include "facts/closed_amplitude.hpp"
#include "facts/dependence.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

using Definition = ShortestForm::Definition;

constexpr std::size_t most_told_elements = 200;
// Of symbols each of which is asked for by itself.
constexpr std::size_t most_asked = 60;
constexpr std::size_t most_listed = 12;

Definition equation_of(const GiNaC::ex& left, const GiNaC::ex& right) {
  return {form_of(left).form, form_of(right).form};
}

bool is_isotropic(const Problem& problem) {
  return std::holds_alternative<Isotropic>(problem->tangential);
}

class Facts {
 public:
  explicit Facts(const Derivation& derivation)
      : derivation_(derivation), problem_(derivation.problem), model_(*derivation.model) {}

  std::vector<Fact> all() {
    const std::vector<Symbol> symbols = of_scene(), missing = not_entering(symbols);
    const bool proportional = is_proportional_to_frequency(model_);
    if (proportional && missing.size() == symbols.size())
      everything_cancels();
    else if (!missing.empty())
      tell_not_entering(missing);
    if (proportional && missing.size() < symbols.size())
      found_.push_back({"proportional_to_frequency",
                        {quantity("v*"), " is proportional to the frequency: besides its factor ",
                         omega(), " it does not depend on it"}});
    tell_resonances();
    tell_sinking();
    tell_closed_amplitude();
    return std::move(found_);
  }

 private:
  /// Elements and the mass.
  std::vector<Symbol> of_scene() const {
    std::vector<Symbol> symbols;
    if (problem_->mass) symbols.push_back(problem_->mass->symbol);
    if (problem_->mount_mass && !problem_->mass) symbols.push_back(problem_->mount_mass->symbol);
    if (problem_->mount_mass && problem_->mass &&
        problem_->mount_mass->symbol != problem_->mass->symbol)
      symbols.push_back(problem_->mount_mass->symbol);
    for (const Symbol& symbol : *problem_->elements)
      if (!is_rest(symbol)) symbols.push_back(symbol);
    return symbols;
  }

  /// What a measured contact carries at rest enters no v*, by what it is.
  bool is_rest(const Symbol& symbol) const {
    return std::any_of(problem_->measured.begin(), problem_->measured.end(),
                       [&](const MeasuredStiffness& each) { return each.rest == symbol; });
  }

  std::vector<Symbol> not_entering(const std::vector<Symbol>& symbols) const {
    const std::vector<Symbol>& printed = derivation_.parameters;
    const bool each = printed.size() <= most_asked;
    std::vector<Symbol> result;
    std::set<std::string> unprinted;
    for (const Symbol& symbol : symbols) {
      const bool is_printed = std::find(printed.begin(), printed.end(), symbol) != printed.end();
      if (!is_printed) unprinted.insert(to_text(symbol));
      if (!is_printed || (each && is_independent_of(model_, {to_text(symbol)})))
        result.push_back(symbol);
    }
    ensure(unprinted.empty() || is_independent_of(model_, unprinted),
           "v* does not depend on what its formula does not hold");
    return result;
  }

  void tell_not_entering(const std::vector<Symbol>& missing) {
    Prose words = listed(missing, problem_);
    words += {missing.size() == 1 ? " does not enter " : " do not enter ", quantity("v*")};
    found_.push_back({"not_in_formula", std::move(words)});
  }

  void everything_cancels() {
    const bool rigid = problem_->rigid();
    const std::string words =
        rigid && is_isotropic(problem_)
            ? "With a rigid drive the rheology of an isotropic contact cancels"
            : "What contact and drive are made of cancels";
    found_.push_back({rigid && is_isotropic(problem_) ? "rheology_cancels" : "elements_cancel",
                      words,
                      {equation_of(quantity("v*"), derivation_.critical_velocity)}});
  }

  void tell(const Resonance& resonance) {
    using Kind = Resonance::Kind;
    if (!resonance.frequency || !resonance.definitions.empty()) return;
    const auto [key, words] =
        resonance.kind == Kind::resonance
            ? std::pair("resonance", " is infinite where body and drive resonate")
        : resonance.kind == Kind::antiresonance
            ? std::pair("antiresonance",
                        " vanishes at the antiresonance of contact point and body, "
                        "where the oscillation does not lower friction at any speed")
            : std::pair("mount_resonance",
                        " is infinite where mount and contact resonate along the normal");
    found_.push_back({key, {quantity("v*"), words}, {equation_of(omega(), *resonance.frequency)}});
  }

  void tell_resonances() {
    bool zeros = false, poles = false, no_zero = true, no_pole = true;
    for (const Resonance& resonance : resonances(derivation_)) {
      tell(resonance);
      const bool vanishes = resonance.kind == Resonance::Kind::antiresonance;
      const bool kept_off = resonance.damped && !resonance.absorbing;
      (vanishes ? zeros : poles) = true;
      if (!kept_off) (vanishes ? no_zero : no_pole) = false;
    }
    const bool finite = poles && no_pole, above = zeros && no_zero;
    if (!finite && !above) return;
    const char* kept = finite && above ? "finite and above 0" : finite ? "finite" : "above 0";
    found_.push_back(
        {"damped",
         {"Dampers keep ", quantity("v*"), std::string(" ") + kept + " at every frequency"}});
  }

  /// What the rulebook says of amplitudes, as far as the values for it are there.
  std::string never_closed() const {
    if (!carries_load(problem_) && !rules::load_is_mean_force(problem_)) {
      const auto kind = problem_->indenter ? rules::SceneKind::no_static_load_below_indenter
                                           : rules::SceneKind::no_static_load;
      return rules::cell(rules::Question::mean_load, kind).reason;
    }
    try {
      return rules::answer(rules::Question::closed_amplitude, problem_).reason;
    } catch (const InputError&) {
      return "";
    }
  }

  /// "K_n(0) = 0" at the end of a reason as mathematics.
  static Prose at_rest_in_formulas(const std::string& reason) {
    for (const std::string stiffness : {"K_n", "E"}) {
      const std::string end = ": " + stiffness + "(0) = 0";
      if (reason.ends_with(end))
        return {reason.substr(0, reason.size() - end.size()) + ", ", stated(quantity(stiffness), 0),
                " at rest"};
    }
    return reason;
  }

  void tell_sinking() {
    if (!rules::load_is_mean_force(problem_) || carries_load(problem_)) return;
    const GiNaC::ex load = symbol(problem_->load->symbol);
    found_.push_back({"sinks",
                      {"The contact carries no load at rest: under ", load,
                       " it sinks at a steady speed, and its force oscillates about ", load}});
  }

  void tell_closed_amplitude() {
    if (const std::string reason = never_closed(); !reason.empty()) {
      Prose words = "No amplitude keeps the contact closed: ";
      words += at_rest_in_formulas(reason);
      found_.push_back({"never_closed", std::move(words)});
      return;
    }
    const std::string place = problem_->indenter ? " at the indenter's centre" : "";
    if (problem_->mount) return tell_closed_below_mount();
    const GiNaC::ex amplitude = symbol({"du_z"});
    Prose words{"The contact stays closed" + place + " while "};
    FoundForm bound = find_closed_amplitude(problem_);
    if (!bound.form) {
      const GiNaC::ex K_n = quantity("K_n");
      if (rules::load_is_mean_force(problem_))
        words += {amplitude * GiNaC::abs(K_n), " is below ", symbol(problem_->load->symbol)};
      else
        words += {amplitude * GiNaC::abs(K_n),
                  " is below ",
                  symbol({"u_z0"}),
                  " times ",
                  K_n,
                  " at rest"};
      found_.push_back({"closed_amplitude", std::move(words)});
      return;
    }
    words += {amplitude, " is below ", quantity("du_max")};
    Fact fact{"closed_amplitude", std::move(words), std::move(bound.form->definitions)};
    fact.lines.push_back({form_of(quantity("du_max")).form, std::move(bound.form->velocity)});
    found_.push_back(std::move(fact));
  }

  /// In stiffnesses: with the mount's it fills no line of words.
  void tell_closed_below_mount() {
    const GiNaC::ex K_n = quantity("K_n"), A_z = model_.balance().normal_amplitude;
    const GiNaC::ex force = GiNaC::abs((A_z * K_n).subs(laplace() == GiNaC::I * omega()));
    Prose words{"The contact stays closed while ", force, " is below "};
    if (problem_->load)
      words += {symbol(problem_->load->symbol)};
    else
      words += {symbol({"u_z0"}), " times ", K_n, " at rest"};
    found_.push_back({"closed_amplitude", std::move(words)});
  }

  const Derivation& derivation_;
  const Problem& problem_;
  const SymbolicModel& model_;
  std::vector<Fact> found_;
};

bool is_too_large(const Problem& problem) {
  std::size_t elements = 0;
  for_each_element(problem, [&elements](const Element&) { ++elements; });
  return elements > most_told_elements;
}

}  // namespace

std::vector<Fact> facts(const Derivation& derivation) {
  const AlgebraLock lock;
  if (is_too_large(derivation.problem)) return {};
  return Facts(derivation).all();
}

std::vector<std::string> facts_in_text(const Problem& problem) {
  const AlgebraLock lock;
  if (is_too_large(problem) || !rules::answer(rules::Question::derivation, problem)) return {};
  const NamesOfScene names(problem);
  std::vector<std::string> texts;
  for (const Fact& fact : facts(derive(problem))) texts.push_back(text_of(fact));
  return texts;
}

std::string text_of(const Fact& fact) {
  std::string text = fact.words.text();
  for (std::size_t i = 0; i < fact.lines.size(); ++i)
    text += (i == 0 ? ": " : "; ") +
            text_dialect().equation({false, fact.lines[i].name}, {false, fact.lines[i].meaning});
  return text;
}

Prose listed(const std::vector<Symbol>& symbols, const Problem& problem) {
  std::map<std::string, std::size_t> entries, here;
  for (const Symbol& symbol : *problem->elements) ++entries[symbol.name];
  for (const Symbol& symbol : symbols) ++here[symbol.name];
  std::vector<Symbol> names;
  for (const Symbol& symbol : symbols) {
    const bool whole = symbol.entry > 0 && here[symbol.name] == entries[symbol.name];
    const Symbol name = whole ? Symbol{symbol.name} : symbol;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const std::size_t more = names.size() > most_listed ? names.size() - most_listed : 0;
  names.resize(names.size() - more);
  Prose words;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool last = more == 0 && i + 1 == names.size();
    words += {i == 0 ? "" : last ? " and " : ", ", vcrit::symbolic::symbol(names[i])};
  }
  if (more > 0) words += fmt::format(" and {} more", more);
  return words;
}

}  // namespace vcrit::symbolic
