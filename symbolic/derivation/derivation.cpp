#include "derivation/derivation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <map>
#include <set>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "derivation/factors.hpp"
#include "derivation/loaded.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "formula/prose.hpp"
#include "formula/symbols.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

std::atomic<std::size_t> made = 0;

/// Its last owner may be in any thread.
std::shared_ptr<const SymbolicModel> model_of(const Problem& problem) {
  return {new SymbolicModel(problem), [](const SymbolicModel* model) {
            const AlgebraLock lock;
            delete model;
          }};
}

ex velocity(const ex& amplitude) {
  Factors factors;
  factors.multiply_product(amplitude);
  factors.cancel();
  return omega() * factors.modulus();
}

/// v* = omega |B|, with and without what the scene's contact and drive have in common.
void write_condition(const SymbolicModel& model, std::vector<Line>& lines) {
  const ex v = quantity("v*");
  const ex B = quantity("B"), phase = quantity("phi");
  const ex least =
      quantity("v0") - omega() * GiNaC::abs(B) * GiNaC::sin(omega() * quantity("t") + phase);
  lines.push_back({{"The contact point slides at ", least, ", with ", phase, " the phase of ", B,
                    "; it never stops where ", quantity("v0"), " is above"},
                   v,
                   omega() * GiNaC::abs(B)});
  lines.push_back({"For any linear structure", v, velocity(model.balance().general_amplitude)});
  lines.push_back({"For any networks (24)", v, velocity(model.balance().contact_amplitude)});
  if (model.identities().empty()) return;
  for (const Line& identity : model.identities()) lines.push_back(identity);
  const std::optional<ex> ratio = model.isotropic_ratio();
  if (!ratio || ratio->is_equal(1) || !model.has_drive())
    return lines.push_back({"With this", v, velocity(model.amplitude({}))});
  // |K_n + g (K_d - m omega^2)| rather than |14 K_n + 17 K_d - 17 m omega^2|/14.
  const ex g = positive_quantity("g");
  Change change;
  change.ratio = 1 / g;
  lines.push_back({{"With this, and ", stated(g, quantity("K_n") / quantity("K_t"))},
                   g,
                   (1 / *ratio).normal()});
  lines.push_back({"", v, by_letter(velocity(model.amplitude(change)), g)});
}

/// "Normal contact, drive, with s = i omega" before the first of the lines. Names of parts come
/// before the network that they are of.
void write_networks(const SymbolicModel& model, bool measured, std::vector<Line>& lines) {
  const std::map<std::string, std::string> words{
      {"K_n", "normal contact"}, {"K_t", "tangential contact"}, {"K_d", "drive"}, {"K_m", "mount"}};
  const ex amplitude = model.amplitude({});
  std::vector<Line> inner;
  std::vector<std::string> written;
  for (const auto& [name, network] : model.networks()) {
    if (!amplitude.has(quantity(name))) continue;
    written.push_back(words.at(name));
    const ex k = nested(network.reduction(), {}, inner).value;
    inner.push_back({"", quantity(name), k});
  }
  if (inner.empty()) return;
  written.front().front() = static_cast<char>(std::toupper(written.front().front()));
  inner.front().words = {fmt::format("{}, with ", joined(written, ", ")),
                         stated(laplace(), GiNaC::I * omega())};
  if (measured)
    inner.front().words +=
        {"; storage stiffness and loss factor of the contact are measured, in a table over ",
         omega()};
  lines.insert(lines.end(), inner.begin(), inner.end());
}

/// The symbols of the formula, mass and friction first, elements in the order of writing.
std::vector<Symbol> parameters(const Problem& problem, const Formula& formula) {
  std::vector<Symbol> candidates{{"mu0"}, {"omega"}, {"du_z"}};
  if (problem->mass) candidates.push_back(problem->mass->symbol);
  if (problem->mount_mass) candidates.push_back(problem->mount_mass->symbol);
  std::sort(candidates.begin() + 3, candidates.end());
  candidates.erase(std::unique(candidates.begin() + 3, candidates.end()), candidates.end());
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic != nullptr && !isotropic->quantity.value)
    candidates.push_back(isotropic->quantity.symbol);
  for (const Symbol& symbol : *problem->elements) candidates.push_back(symbol);

  std::set<std::string> there;
  const auto collect = [&there](const ex& expression) {
    for (auto it = expression.preorder_begin(); it != expression.preorder_end(); ++it)
      if (GiNaC::is_a<GiNaC::symbol>(*it))
        there.insert(GiNaC::ex_to<GiNaC::symbol>(*it).get_name());
  };
  collect(formula.velocity);
  for (const Line& line : formula.definitions) collect(line.right);
  std::erase_if(candidates, [&](const Symbol& s) { return !there.contains(to_text(s)); });
  return candidates;
}

/// The formula as the last of the lines and as the result.
void write_result(const Formula& formula, Derivation& derivation) {
  derivation.lines.back().right = formula.velocity;
  derivation.critical_velocity = formula.velocity;
  derivation.definitions = formula.definitions;
  derivation.equation = formula.equation.empty() ? "(24)" : formula.equation;
  derivation.parameters = parameters(derivation.problem, formula);
}

}  // namespace

Derivation derive(const Problem& problem) {
  rules::require(rules::Question::derivation, problem);
  const AlgebraLock lock;
  const NamesOfScene names(problem);
  ++made;
  Derivation result{problem, model_of(problem), {}, {}, {}, {}, {}};
  const SymbolicModel& model = *result.model;
  const std::optional<Formula> formula = model.formula({});
  ensure(formula.has_value(), "a scene without a limit has a formula");
  result.lines = model.balance().lines;
  write_condition(model, result.lines);
  if (problem->names.contains(frequency_symbol.name))
    result.lines.push_back(
        {"Angular frequency", omega(), 2 * positive_quantity("pi") * symbol(frequency_symbol)});
  write_networks(model, !problem->measured.empty(), result.lines);
  if (const auto line = indentation_line(problem)) result.lines.push_back(*line);
  if (result.lines.back().left.is_equal(quantity("v*"))) result.lines.pop_back();
  result.lines.push_back({"Result", quantity("v*"), {}});
  write_result(*formula, result);
  return result;
}

Derivation nested_form(Derivation derivation) {
  const AlgebraLock lock;
  write_result(derivation.model->nested_formula(), derivation);
  return derivation;
}

std::size_t derivations_made() { return made; }

}  // namespace vcrit::symbolic
