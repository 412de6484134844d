#include "emit/languages/cpp/groups.hpp"

#include <algorithm>
#include <cstdlib>

#include "analysis/dimensionless.hpp"
#include "base/errors.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

/// The names of a product of powers, each as often as it occurs, above and below the bar.
struct Monomial {
  std::vector<std::string> above, below;

  explicit Monomial(const ex& product) {
    add(product, 1);
    // GiNaC's order changes from run to run.
    std::sort(above.begin(), above.end());
    std::sort(below.begin(), below.end());
  }

 private:
  void add(const ex& factor, int exponent) {
    if (GiNaC::is_a<GiNaC::mul>(factor)) {
      for (const ex& part : factor) add(part, exponent);
    } else if (GiNaC::is_a<GiNaC::power>(factor)) {
      const ex power = factor.op(1);
      ensure(power.info(GiNaC::info_flags::integer), "groups have whole powers");
      add(factor.op(0), exponent * GiNaC::ex_to<GiNaC::numeric>(power).to_int());
    } else {
      ensure(GiNaC::is_a<GiNaC::symbol>(factor), "groups are products of symbols");
      const std::string name = GiNaC::ex_to<GiNaC::symbol>(factor).get_name();
      auto& side = exponent > 0 ? above : below;
      side.insert(side.end(), static_cast<std::size_t>(std::abs(exponent)), name);
    }
  }
};

/// "kappa_k[2]"
struct GroupName {
  std::string name;
  int entry = 0;

  explicit GroupName(const std::string& text) : name(text.substr(0, text.find('['))) {
    if (name.size() < text.size()) entry = std::stoi(text.substr(name.size() + 1));
  }
};

class GroupWriter {
 public:
  GroupWriter(const Derivation& derivation, Program& program, const SymbolValue& value)
      : derivation_(derivation), program_(program), value_(value) {
    const Problem& problem = derivation.problem;
    symbols_["omega"] = {"omega"};
    if (problem->mass) symbols_["m"] = problem->mass->symbol;
    if (problem->mount_mass)
      symbols_[to_text(problem->mount_mass->symbol)] = problem->mount_mass->symbol;
    for (const Symbol& symbol : *problem->elements) symbols_[to_text(symbol)] = symbol;
  }

  std::vector<Group> write() {
    // The receptance of a measured drive is a complex number of its own at each frequency.
    for (const Line& line : dimensionless(derivation_).groups)
      if (!line.right.has(quantity("R_d"))) add(line);
    return std::move(groups_);
  }

 private:
  NodeId product(const std::vector<std::string>& names) {
    NodeId whole = program_.constant(1);
    for (const std::string& name : names)
      whole = program_.multiply(whole, value_(program_, symbols_.at(name)));
    return whole;
  }

  void add(const Line& line) {
    const GroupName name(base_name(GiNaC::ex_to<GiNaC::symbol>(line.left).get_name()));
    const Monomial monomial(line.right);
    const NodeId value = program_.divide(product(monomial.above), product(monomial.below));
    const std::string meaning = to_text(line.right);
    const std::string member = named_after(name.name);
    if (name.entry == 0) return groups_.push_back({member, meaning, {value}, false});
    auto same = std::find_if(groups_.begin(), groups_.end(),
                             [&](const Group& g) { return g.name == member; });
    if (same == groups_.end())
      same = groups_.insert(same, {member, meaning, of_array(name.name), true});
    same->values.at(static_cast<std::size_t>(name.entry) - 1) = value;
  }

  /// "beta_M" of "beta_m" where the scene calls m so.
  std::string named_after(const std::string& group) const {
    const std::size_t symbol = group.find('_') + 1;
    return group.substr(0, symbol) + as_called(derivation_.problem, {group.substr(symbol)}).name;
  }

  /// What entries are without a group.
  std::vector<NodeId> of_array(const std::string& group) {
    const std::string array = group.substr(group.find('_') + 1);
    const bool stiffness = group.starts_with("kappa_");
    std::vector<NodeId> values;
    for (int entry = 1; entry <= derivation_.problem->source->arrays.at(array); ++entry) {
      const bool is_there = symbols_.contains(to_text(Symbol{array, entry}));
      values.push_back(program_.constant(stiffness && is_there ? 1 : 0));
    }
    return values;
  }

  const Derivation& derivation_;
  Program& program_;
  const SymbolValue& value_;
  std::map<std::string, Symbol> symbols_;
  std::vector<Group> groups_;
};

}  // namespace

std::vector<Group> dimensionless_groups(const Derivation& derivation, Program& program,
                                        const SymbolValue& value) {
  return GroupWriter(derivation, program, value).write();
}

}  // namespace vcrit::symbolic
