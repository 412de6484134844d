#include "analysis/dimensionless.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "base/errors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

std::optional<Symbol> first_of(const Network& network, NumberRole wanted) {
  std::optional<Symbol> found;
  for_each_element(network, [&](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
      if (!found && role == wanted) found = symbol;
    });
  });
  return found;
}

std::vector<const Network*> networks_of(const Problem& problem) {
  std::vector<const Network*> result{&problem->normal.network()};
  if (const auto* tangential = std::get_if<ReducedNetwork>(&problem->tangential))
    result.push_back(&tangential->network());
  if (const auto* drive = problem->drive_network()) result.push_back(&drive->network());
  if (problem->mount) result.push_back(&problem->mount->network());
  return result;
}

class Groups : public DimensionlessGroups {
 public:
  explicit Groups(const Problem& problem) {
    for (const Network* network : networks_of(problem)) choose_reference(*network);
    ensure(reference_ || viscous_, "a network has springs or dampers");
    for (const Network* network : networks_of(problem)) visit(*network, reference_);
    if (problem->mass)
      add_mass({"m"}, problem->drive_network() != nullptr
                          ? first_of(problem->drive_network()->network(), NumberRole::stiffness)
                          : reference_);
    if (problem->mount_mass && !scale.contains(symbol(problem->mount_mass->symbol)))
      add_mass(problem->mount_mass->symbol,
               first_of(problem->mount->network(), NumberRole::stiffness));
    if (problem->receptance() != nullptr) add_receptance();
  }

 private:
  void choose_reference(const Network& network) {
    if (!reference_) reference_ = first_of(network, NumberRole::stiffness);
    if (!viscous_) viscous_ = first_of(network, NumberRole::damping);
  }

  void add(const char* group, const Symbol& element, const ex& meaning, const ex& in_reference) {
    const ex name = positive_quantity(std::string(group) + "_" + to_text(element));
    const bool is_new = scale.emplace(symbol(element), name * in_reference).second;
    if (is_new) lines.push_back({"", name, meaning});
  }

  /// A spring in units of the reference.
  ex measured(const Symbol& spring) {
    if (spring == *reference_) {
      scale.emplace(symbol(spring), 1);
      return 1;
    }
    add("kappa", spring, symbol(spring) / symbol(*reference_), 1);
    return scale.at(symbol(spring));
  }

  void add_damper(const Symbol& damper, const std::optional<Symbol>& beside) {
    const ex c = symbol(damper);
    if (beside) return add("theta", damper, omega() * c / symbol(*beside), measured(*beside));
    if (damper == *viscous_)
      scale.emplace(c, 1);
    else
      add("kappa", damper, c / symbol(*viscous_), 1);
  }

  // The spring beside a damper is the first one of the smallest part of the network around it.
  void visit(const Network& network, std::optional<Symbol> beside) {
    if (const auto* element = std::get_if<Element>(&network.form)) return visit(*element, beside);
    if (const auto inside = first_of(network, NumberRole::stiffness)) beside = inside;
    if (const auto* series = std::get_if<Series>(&network.form)) visit(series->parts, beside);
    if (const auto* parallel = std::get_if<Parallel>(&network.form)) visit(parallel->parts, beside);
    if (const auto* graph = std::get_if<Graph>(&network.form)) visit(graph->parts, beside);
  }
  void visit(const std::vector<Network>& parts, const std::optional<Symbol>& beside) {
    for (const Network& part : parts) visit(part, beside);
  }
  void visit(const Element& element, const std::optional<Symbol>& beside) {
    for_each_number(element, [&](const Symbol& number, NumberRole role) {
      switch (role) {
        case NumberRole::stiffness:
          measured(number);
          return;
        case NumberRole::damping:
          return add_damper(number, beside);
        case NumberRole::time:
          return add("theta", number, omega() * symbol(number), 1);
        case NumberRole::mass:
          return add_mass(number, beside);
        case NumberRole::loss_factor:
        case NumberRole::factor:
          return;
      }
    });
  }

  void add_mass(const Symbol& mass, const std::optional<Symbol>& beside) {
    const ex m = symbol(mass);
    if (const auto spring = beside ? beside : reference_)
      add("beta", mass, m * GiNaC::pow(omega(), 2) / symbol(*spring), measured(*spring));
    else
      add("beta", mass, m * omega() / symbol(*viscous_), 1);
  }

  void add_receptance() {
    const ex stiffness = reference_ ? symbol(*reference_) : omega() * symbol(*viscous_);
    scale.emplace(quantity("R_d"), quantity("rho_d"));
    lines.push_back({"", quantity("rho_d"), stiffness * quantity("R_d")});
  }

  std::optional<Symbol> reference_, viscous_;
};

}  // namespace

DimensionlessGroups dimensionless_groups(const Problem& problem) {
  const AlgebraLock lock;
  return Groups(problem);
}

// v* over mu0 omega du_z does not change with the units of stiffness and time: 1 for the reference
// and for omega leaves what it is.
DimensionlessForm dimensionless(const Derivation& derivation) {
  const AlgebraLock lock;
  const DimensionlessGroups groups = dimensionless_groups(derivation.problem);
  Change change;
  change.scale = groups.scale;
  const std::optional<Formula> formula = derivation.model->formula(change);
  ensure(formula.has_value(), "a scene without a limit has a formula");
  const GiNaC::exmap units{{omega(), 1}, {laplace(), GiNaC::I}};
  DimensionlessForm form;
  form.velocity = (formula->velocity / symbol({"mu0"}) / symbol({"du_z"}) / omega()).subs(units);
  for (const Line& line : formula->definitions)
    form.definitions.push_back({line.words, line.left, line.right.subs(units)});
  const auto holds = [&](const ex& group) {
    return form.velocity.has(group) ||
           std::any_of(form.definitions.begin(), form.definitions.end(),
                       [&](const Line& line) { return line.right.has(group); });
  };
  for (const Line& line : groups.lines)
    if (holds(line.left)) form.groups.push_back(line);
  return form;
}

}  // namespace vcrit::symbolic
