#include "shortest/alphabet.hpp"

#include <optional>
#include <sstream>

#include "base/errors.hpp"
#include "derivation/model.hpp"
#include "formula/names.hpp"
#include "formula/order.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic::shortest {

Alphabet::Alphabet(const Problem& problem, const DimensionlessGroups* groups, OmegaPlace omega)
    : problem_(problem), groups_(groups), omega_(omega) {
  measures_.dimensionless = groups != nullptr;
  const bool in_front = omega == OmegaPlace::in_front;
  parts_.prefactor = all_.symbol("", in_front ? 2 : 1, true);
  parts_.omega = groups != nullptr ? Expressions::number(1) : symbol({"omega"}, {0, -1});
  if (groups == nullptr) measures_.odd.insert(parts_.omega.node);
  // mu0 du_z omega
  if (!in_front) parts_.prefactor = all_.multiply(parts_.prefactor, parts_.omega);
  parts_.normal = &problem_->normal.network();
  if (const auto* own = std::get_if<ReducedNetwork>(&problem_->tangential))
    parts_.tangential = &own->network();
  if (const auto* drive = problem_->drive_network()) parts_.drive = &drive->network();
  if (problem_->mount) parts_.mount = &problem_->mount->network();
  for (const Network* network : {parts_.normal, parts_.tangential, parts_.drive, parts_.mount})
    if (network != nullptr) add(*network);
  if (problem_->mass) parts_.mass = symbol(problem_->mass->symbol, {1, 2});
  if (problem_->mount_mass) parts_.mount_mass = symbol(problem_->mount_mass->symbol, {1, 2});
  if (isotropic() != nullptr) parts_.ratio = ratio(*isotropic());
}

Presentations Alphabet::presentations(const Thrift& thrift) {
  const auto lookup = [this](const Symbol& symbol) { return symbols_.at(symbol); };
  return {all_, parts_.omega, lookup, thrift, omega_ == OmegaPlace::in_front};
}

Ex Alphabet::stiffness(const std::string& name, bool positive) {
  const Ex ex = positive ? all_.symbol(name) : all_.signed_symbol(name);
  measures_.symbols[ex.node] = {1, 0};
  if (base_name(name).ends_with("''")) measures_.odd.insert(ex.node);
  return ex;
}

Ex Alphabet::element(const std::string& name) const {
  for (const auto& [symbol, ex] : symbols_)
    if (to_text(symbol) == name) return ex;
  throw Bug("an expression holds symbols of its scene");
}

ShortestForm Alphabet::written(const Ex& velocity,
                               const std::vector<NamedLine>& definitions) const {
  ShortestForm form = Lines(all_, measures_, velocity, definitions).form();
  if (isotropic() != nullptr) form.ratio = ratio_words(form);
  return form;
}

Ex Alphabet::symbol(const Symbol& symbol, const Measure& measure) {
  const auto [known, is_new] = symbols_.try_emplace(symbol);
  if (!is_new) return known->second;
  if (groups_ != nullptr) {
    const auto scaled = groups_->scale.find(symbolic::symbol(symbol));
    if (scaled != groups_->scale.end()) return known->second = in_groups(scaled->second);
  }
  known->second = all_.symbol(to_text(symbol));
  measures_.symbols[known->second.node] = groups_ != nullptr ? Measure{} : measure;
  return known->second;
}

/// A number, a group, or a product of groups.
Ex Alphabet::in_groups(const GiNaC::ex& product) {
  if (GiNaC::is_a<GiNaC::mul>(product)) {
    Ex whole = Expressions::number(1);
    for (const GiNaC::ex& factor : in_order_of_text(product))
      whole = all_.multiply(whole, in_groups(factor));
    return whole;
  }
  if (GiNaC::is_a<GiNaC::symbol>(product)) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(product).get_name();
    const auto [known, is_new] = group_symbols_.try_emplace(name);
    if (is_new) {
      known->second = all_.symbol(name);
      for (const Line& group : groups_->lines)
        if (group.left.is_equal(product) && group.right.degree(omega()) % 2 != 0)
          measures_.odd.insert(known->second.node);
    }
    return known->second;
  }
  ensure(product.is_equal(1), "a group is a symbol");
  return Expressions::number(1);
}

void Alphabet::add(const Network& network) {
  static const std::map<NumberRole, Measure> measures{
      {NumberRole::stiffness, {1, 0}},   {NumberRole::damping, {1, 1}},
      {NumberRole::time, {0, 1}},        {NumberRole::mass, {1, 2}},
      {NumberRole::loss_factor, {0, 0}}, {NumberRole::factor, {0, 0}}};
  for_each_element(network, [&](const Element& element) {
    for_each_number(element,
                    [&](const Symbol& each, NumberRole role) { symbol(each, measures.at(role)); });
  });
}

/// g = K_n/K_t: Mindlin's (2 - nu)/(2 (1 - nu)), or a number.
Ex Alphabet::ratio(const Isotropic& isotropic) {
  const bool poisson = isotropic.by == Isotropic::By::poisson;
  if (isotropic.quantity.value) return number_ratio(isotropic);
  const Ex given = symbol(isotropic.quantity.symbol, {});
  if (!poisson) return all_.power(given, -1);
  const Ex two = Expressions::number(2), one = Expressions::number(1);
  const Ex meaning =
      all_.product({{all_.subtract(two, given), 1}, {two, -1}, {all_.subtract(one, given), -1}});
  return all_.named("g", meaning, operations(all_, meaning), true);
}

Ex Alphabet::number_ratio(const Isotropic& isotropic) {
  const GiNaC::ex inverse = 1 / isotropic_ratio(isotropic);
  if (inverse.is_equal(1)) return Expressions::number(1);
  std::ostringstream digits;
  digits << inverse;
  ratio_ = digits.str();
  const bool whole = inverse.info(GiNaC::info_flags::integer);
  const Ex number = all_.symbol(digits.str(), whole ? 0 : 1);
  measures_.symbols[number.node] = {};
  return all_.named("g", number, 1, true);
}

/// "g = K_n/K_t (Mindlin) for nu = 0.3", or by its number where that has no line.
Prose Alphabet::ratio_words(const ShortestForm& form) const {
  const Quantity& given_ratio = isotropic()->quantity;
  const bool poisson = isotropic()->by == Isotropic::By::poisson;
  std::optional<Form> name;
  if (given_ratio.value && !ratio_.empty()) name = Form{Form::Kind::number, ratio_, {}, {}, {}, 1};
  for (const ShortestForm::Definition& definition : form.definitions)
    if (all_.name(parts_.ratio.node) == "g" && definition.name.text.starts_with("g"))
      name = definition.name;
  if (!name) return {};
  const GiNaC::ex normal = symbolic::quantity("K_n"), other = symbolic::quantity("K_t");
  Prose words{Statement{{false, *name}, Statement::Relation::equal, form_of(normal / other)},
              poisson ? " (Mindlin)" : ""};
  if (given_ratio.value)
    words += {" for ", stated_number(poisson ? symbolic::quantity("nu") : other / normal,
                                     *given_ratio.value)};
  return words;
}

}  // namespace vcrit::symbolic::shortest
