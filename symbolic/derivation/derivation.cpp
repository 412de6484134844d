#include "derivation/derivation.hpp"

#include <set>

#include "base/errors.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "derivation/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

ex velocity(const ex& amplitude) {
  Factors factors;
  factors.multiply_rational(amplitude);
  factors.cancel();
  return omega() * factors.modulus();
}

/// v* = omega |B|, with and without what the scene's contact and drive have in common.
void write_condition(const Model& model, std::vector<Line>& lines) {
  const ex v = quantity("v*");
  lines.push_back(
      {"Sliding without a stop ends where the contact velocity v0 - |omega B| sin(...) "
       "first touches zero",
       v, omega() * GiNaC::abs(quantity("B"))});
  lines.push_back({"For any networks (24)", v, velocity(model.balance().contact_amplitude)});
  if (model.identities().empty()) return;
  for (const Line& identity : model.identities()) lines.push_back(identity);
  lines.push_back({"With this", v, velocity(model.amplitude({}))});
}

void write_networks(const Model& model, std::vector<Line>& lines) {
  const std::map<std::string, std::string> words{{"K_n", "Normal contact, with s = i*omega"},
                                                 {"K_t", "Tangential contact, with s = i*omega"},
                                                 {"K_d", "Drive, with s = i*omega"}};
  const ex amplitude = model.amplitude({});
  std::vector<Line> inner;
  for (const auto& [name, reduction] : model.networks()) {
    if (!amplitude.has(quantity(name))) continue;
    const std::size_t before = inner.size();
    const ex k = nested(reduction, {}, inner).value;
    for (std::size_t i = before; i < inner.size(); ++i)
      lines.push_back({"Inside: " + words.at(name), inner[i].left, inner[i].right});
    lines.push_back({words.at(name), quantity(name), k});
  }
}

/// The symbols of the formula, mass and friction first, elements in the order of writing.
std::vector<Symbol> parameters(const Scene& scene, const Formula& formula) {
  std::vector<Symbol> candidates{{"mu0"}, {"omega"}, {"du_z"}, {"m"}};
  const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  if (isotropic != nullptr && !isotropic->quantity.value)
    candidates.push_back(isotropic->quantity.symbol);
  for (const auto& [symbol, value] : scene.elements) candidates.push_back(symbol);

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

}  // namespace

Derivation derive(const Scene& scene) {
  const Model model(scene);
  const std::optional<Formula> formula = model.formula({});
  ensure(formula.has_value(), "a scene without a limit has a formula");
  Derivation result;
  result.lines = model.balance().lines;
  write_condition(model, result.lines);
  write_networks(model, result.lines);
  if (result.lines.back().left.is_equal(quantity("v*"))) result.lines.pop_back();
  result.lines.push_back({"Result", quantity("v*"), formula->velocity});

  const auto stiffness = [&](const std::string& name) {
    ex k = quantity(name);
    for (const Line& identity : model.identities()) k = k.subs(identity.left == identity.right);
    for (const Part& part : model.networks())
      if (k.has(quantity(part.name))) k = k.subs(quantity(part.name) == model.stiffness(part));
    return k;
  };
  result.normal = stiffness("K_n");
  result.tangential = stiffness("K_t");
  if (scene.drive) result.drive = stiffness("K_d");
  result.critical_velocity = formula->velocity;
  result.definitions = formula->definitions;
  result.equation = formula->equation.empty() ? "(24)" : formula->equation;
  result.parameters = parameters(scene, *formula);
  return result;
}

GiNaC::numeric value_at(const ex& formula, const std::vector<Line>& definitions,
                        const std::map<Symbol, GiNaC::numeric>& values) {
  GiNaC::exmap known;
  for (const auto& [name, value] : values) {
    known[symbol(name)] = value;
    known[poisson_ratio(name)] = value;
  }
  const auto omega_value = known.find(omega());
  if (omega_value != known.end()) known[laplace()] = GiNaC::I * omega_value->second;
  const auto evaluate = [&known](const ex& expression) {
    const ex number = expression.subs(known, GiNaC::subs_options::no_pattern).evalf();
    ensure(GiNaC::is_a<GiNaC::numeric>(number), "a formula whose symbols all have values");
    return GiNaC::ex_to<GiNaC::numeric>(number);
  };
  for (const Line& line : definitions) known[line.left] = evaluate(line.right);
  return evaluate(formula);
}

}  // namespace vcrit::symbolic
