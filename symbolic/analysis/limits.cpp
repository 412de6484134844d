#include "analysis/limits.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/abbreviated.hpp"
#include "analysis/shape.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/prose.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Definitions of a limit that is derived in g as well: networks of hundreds have hundreds of
// limits.
constexpr std::size_t most_derived_twice = 20;

/// Elements that go to a limit together: one, or all entries of an array.
struct ElementGroup {
  ex label;
  std::vector<Symbol> symbols;
  bool dissipates;
};

std::set<Symbol> element_symbols(const Network& network) {
  std::set<Symbol> found;
  for_each_element(network, [&](const Element& e) {
    for_each_number(e, [&](const Symbol& symbol, NumberRole) { found.insert(symbol); });
  });
  return found;
}

/// Of all networks but the drive, the mount among them.
std::set<Symbol> symbols_beside_drive(const Problem& problem) {
  std::set<Symbol> found = element_symbols(problem->normal.network());
  if (const auto* tangential = std::get_if<ReducedNetwork>(&problem->tangential))
    found.merge(element_symbols(tangential->network()));
  if (problem->mount) found.merge(element_symbols(problem->mount->network()));
  return found;
}

/// Whether the symbol sets how fast something relaxes: a damper, or a Maxwell branch's time.
std::map<Symbol, bool> dissipates(const Problem& problem) {
  std::map<Symbol, bool> result;
  const auto add = [&result](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
      result[symbol] = role == NumberRole::damping || role == NumberRole::time;
    });
  };
  for_each_element(problem, add);
  return result;
}

/// The groups of elements among `parameters`, in the order of writing.
std::vector<ElementGroup> element_groups(const Problem& problem,
                                         const std::vector<Symbol>& parameters) {
  const std::map<Symbol, bool> elements = dissipates(problem);
  std::vector<ElementGroup> groups;
  for (const Symbol& parameter : parameters) {
    const auto found = elements.find(parameter);
    if (found == elements.end()) continue;
    const ex label = symbol({parameter.name});
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const ElementGroup& g) {
      return g.label.is_equal(label) && g.dissipates == found->second;
    });
    if (same == groups.end())
      groups.push_back({label, {parameter}, found->second});
    else
      same->symbols.push_back(parameter);
  }
  return groups;
}

/// A drive that is one spring is named by it, unless that spring has other uses.
ex drive_label(const Problem& problem) {
  const auto* element = std::get_if<Element>(&problem->drive_network()->network().form);
  const bool lone_spring = element != nullptr && is_elastic(*element) && is_plain(*element) &&
                           !symbols_beside_drive(problem).contains(element->coefficient.symbol());
  return lone_spring ? symbol(element->coefficient.symbol()) : quantity("K_d");
}

class Collector {
 public:
  Collector(const Derivation& derivation, const Abbreviations& names)
      : own_(derivation),
        names_(names),
        problem_(derivation.problem),
        model_(*derivation.model),
        elements_(element_groups(problem_, own_.parameters)) {}

  std::vector<Limit> collect() {
    single_limits();
    all_dampers_to_zero();
    same_shape();
    return std::move(limits_);
  }

 private:
  /// "cn, ct -> 0"
  static Prose arrow(const std::vector<ex>& what, bool infinite) {
    Prose name;
    for (const ex& each : what)
      name += &each == &what.back() ? Prose{tends(each, infinite)} : Prose{each, ", "};
    return name;
  }
  static Prose both(Prose first, const Prose& then) {
    first += ", ";
    return first += then;
  }

  void add(const Change& change, const Prose& title) {
    const std::optional<Formula> formula = model_.formula(change);
    if (!formula) return;
    limits_.push_back({title.text(), title, formula->equation, formula->velocity,
                       shown(*formula, change), formula->definitions, rates(change)});
  }
  /// In complex stiffnesses there is no k_d for Z, and g is told from numbers: K_n + g (K_d - ...).
  ex shown(const Formula& formula, const Change& change) const {
    if (formula.definitions.size() > most_derived_twice) return formula.velocity;
    if (!formula.definitions.empty()) {
      const Change in_ratio = abbreviated({names_.ratio, {}}, change).front();
      const ex velocity = model_.formula(in_ratio)->velocity;
      return names_.ratio ? by_letter(velocity, names_.ratio->left) : velocity;
    }
    const auto in_names = [&](const Change& each) {
      const bool named = each.ratio.has_value() != change.ratio.has_value() || !each.scale.empty();
      return named ? model_.formula(each)->velocity : formula.velocity;
    };
    return shortest_in(names_, change, in_names, printed_operations);
  }
  // The drive grows fast enough to outrun its own dampers on their way to zero. Where it shares
  // elements with contact or mount, values alone cannot make it rigid.
  GrowthExponents rates(const Change& change) const {
    if (change.ratio) return {};
    GrowthExponents result = change.rates;
    if (change.massless) result[problem_->mass->symbol] = -1;
    if (!change.rigid) return result;
    const std::set<Symbol> others = symbols_beside_drive(problem_);
    for (const Symbol& symbol : element_symbols(problem_->drive_network()->network())) {
      if (others.contains(symbol)) return {};
      result[symbol] += 4;
    }
    return result;
  }
  void add(const Change& change, const std::vector<ex>& what, bool infinite) {
    add(change, arrow(what, infinite));
  }

  bool has_drive() const { return problem_->drive_network() != nullptr && depends_on_drive(); }
  // v* of an isotropic contact under the very same network as a drive is a constant.
  bool depends_on_drive() const { return own_.parameters.size() > 3; }

  void single_limits() {
    if (has_drive()) add({{}, true, false, {}}, {drive_label(problem_)}, true);
    if (problem_->mass) add({{}, false, true, {}}, {symbol({"m"})}, false);
    for (const ElementGroup& group : elements_)
      for (const bool infinite : {false, true}) {
        if (infinite && is_drive(group)) continue;
        Change change;
        for (const Symbol& symbol : group.symbols) change.rates[symbol] = infinite ? 1 : -1;
        add(change, {group.label}, infinite);
      }
  }
  bool is_drive(const ElementGroup& group) const {
    return problem_->drive_network() != nullptr && group.label.is_equal(drive_label(problem_));
  }

  void all_dampers_to_zero() {
    Change change;
    std::vector<ex> labels;
    for (const ElementGroup& group : elements_) {
      if (!group.dissipates) continue;
      labels.push_back(group.label);
      for (const Symbol& symbol : group.symbols) change.rates[symbol] = -1;
    }
    if (labels.empty()) return;
    if (labels.size() > 1) add(change, labels, false);
    if (!has_drive()) return;
    change.rigid = true;
    add(change, both(arrow(labels, false), arrow({drive_label(problem_)}, true)));
  }

  void same_shape() {
    const auto* tangential = std::get_if<ReducedNetwork>(&problem_->tangential);
    if (tangential == nullptr) return;
    const std::optional<ex> ratio =
        ratio_of_same_shape(problem_->normal.network(), tangential->network());
    if (!ratio) return;
    const Prose isotropic{"isotropic contact, ", stated(quantity("K_t"), *ratio * quantity("K_n"))};
    add({{}, false, false, ratio}, isotropic);
    if (!has_drive()) return;
    add({{}, true, false, ratio}, both(isotropic, arrow({drive_label(problem_)}, true)));
  }

  const Derivation& own_;
  const Abbreviations& names_;
  Problem problem_;
  const SymbolicModel& model_;
  std::vector<ElementGroup> elements_;
  std::vector<Limit> limits_;
};

}  // namespace

std::vector<Limit> limits(const Derivation& derivation, const Abbreviations& names) {
  const AlgebraLock lock;
  return Collector(derivation, names).collect();
}

}  // namespace vcrit::symbolic
