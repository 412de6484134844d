#include "scene/element_values.hpp"

#include <fmt/core.h>

#include "base/identifiers.hpp"
#include "base/spelled_names.hpp"
#include "scene/arithmetic.hpp"
#include "scene/document.hpp"

namespace vcrit {

ElementValues::ElementValues(const toml::table& document, const std::string& file,
                             Networks& networks, Quantities& quantities, Scene& scene,
                             Complaints& complaints)
    : document_(document),
      elements_(document::table(document, "elements", file)),
      file_(file),
      networks_(networks),
      quantities_(quantities),
      scene_(scene),
      complaints_(complaints) {}

void ElementValues::read() {
  std::set<std::string> taken;
  for (const auto& [name, dimension] : settings().known()) taken.insert(name);
  uses_ = networks_.names().resolve(networks_.uses());
  expressions_.emplace(elements_, file_, networks_.names(), networks_.given_expressions(), uses_);
  uses_.insert(expressions_->parameters().begin(), expressions_->parameters().end());
  for (const auto& [element, text] : expressions_->all())
    scene_.expressions[to_text(element)] = text;
  std::set<std::string> with_mass = taken;
  with_mass.insert("m");
  // Without a body, m is free for a mass of the drive.
  for (const auto& [name, use] : uses_)
    complaints_.attempt([&, &name = name, &use = use] {
      read(name, use, has_body() || use.dimension == Dimension::mass ? taken : with_mass);
    });
  complaints_.attempt([&] { read_other_keys(uses_); });
  if (complaints_.any()) read_unused();
  refuse_names_beyond_ascii();
}

void ElementValues::read(const std::string& name, const ElementUse& use,
                         const std::set<std::string>& taken) {
  refuse_clash(name, use, taken);
  if (const std::string own_name = own({name}).name; own_name != name)
    scene_.names[own_name] = name;
  if (networks_.is_tabulated(name)) return refuse_to_set(name, {name});
  const toml::node* node = elements_ == nullptr ? nullptr : elements_->get(name);
  if (use.length > 0)
    read_array(name, use, node);
  else
    read_scalar(name, use, node);
}

std::vector<Warning> ElementValues::warnings() const {
  std::vector<Warning> all;
  if (elements_ == nullptr) return all;
  for (const auto& [key, value] : *elements_) {
    const std::string name(key.str());
    if (uses_.contains(name) || networks_.names().is_used(name) || expressions_->is_used(name))
      continue;
    const auto meant = nearest(name, without_value());
    all.push_back({document::place_of(value, file_),
                   fmt::format("element \"{}\" is in no network of this scene{}", name,
                               meant ? fmt::format("; did you mean \"{}\"?", *meant) : "")});
  }
  return all;
}

std::vector<std::string> ElementValues::without_value() const {
  std::vector<std::string> names;
  for (const auto& [name, use] : uses_)
    if (elements_ == nullptr || !elements_->contains(name)) names.push_back(name);
  return names;
}

// Where a network could not be read nobody knows what its elements are, but by their letters; and
// below an indenter on a drive not whether they are the half-space's.
void ElementValues::refuse_names_beyond_ascii() {
  if (elements_ == nullptr) return;
  for (const auto& [key, value] : *elements_) {
    const Place place = document::place_of(value, file_);
    if (const auto complaint = complaint_beyond_ascii(key.str(), 0, place))
      complaints_.add(*complaint);
  }
}

void ElementValues::read_unused() {
  if (elements_ == nullptr) return;
  const bool of_half_space = document_.contains("indenter");
  if (of_half_space && document_.contains("drive")) return;
  for (const auto& [key, value] : *elements_) {
    const std::string name(key.str());
    const bool is_spring = name.starts_with('k'), is_damper = name.starts_with('c');
    if (uses_.contains(name) || value.is_array() || !(is_spring || is_damper)) continue;
    if (expression_in(value)) continue;
    const NumberRow& row = number_row(is_spring ? NumberRole::stiffness : NumberRole::damping);
    const Place place = document::place_of(value, file_);
    complaints_.attempt([&, &value = value] {
      number(value, of_half_space ? row.in_half_space : row.dimension, name, place);
    });
  }
}

void ElementValues::refuse_clash(const std::string& name, const ElementUse& use,
                                 const std::set<std::string>& taken) const {
  check_symbol_name(name, "an element", use.place, taken);
  const toml::table* networks = document::table(document_, "networks", file_);
  if (networks != nullptr && networks->contains(name))
    throw InputError(use.place, fmt::format("\"{}\" as a network and as an element", name),
                     "one of the two");
}

// --set may name the key of an element that is called otherwise, as it may name the keys of
// quantities, unless other elements are called so as well.
void ElementValues::read_other_keys(const Uses& uses) {
  for (const auto& [key, element] : networks_.names().sole()) {
    if (expressions_->has(element)) {
      refuse_to_set(key, element);
      continue;
    }
    quantities_.refuse_both(to_text(element), key);
    const auto set = settings().take(key, uses.at(element.name).dimension, own(element));
    if (set) put(own(element), *set, OverridingValues::place(key));
  }
  for (const auto& [key, element] : networks_.names().shared())
    if (settings().has(key))
      throw InputError(OverridingValues::place(key),
                       fmt::format("\"{}\", which this scene calls {}, as other elements", key,
                                   to_text(element)),
                       fmt::format("\"{}\", which sets them all", to_text(element)));
}

Symbol ElementValues::own(const Symbol& element) const {
  std::set<std::string> others;
  for (const auto& [section, symbol] : symbols_of_sections)
    if (scene_.names.contains(symbol)) others.insert(symbol);
  return {own_name_of(element.name, others), element.entry};
}

void ElementValues::rename_elements() {
  const auto name = [this](const Symbol& symbol) {
    return expressions_->amount(networks_.names().of(symbol),
                                [this](const Symbol& element) { return own(element); });
  };
  rename(scene_.normal, name);
  if (auto* tangential = std::get_if<Network>(&scene_.tangential)) rename(*tangential, name);
  if (scene_.drive) rename(*scene_.drive, name);
  if (scene_.mount) rename(*scene_.mount, name);
  expressions_->refuse_divisions([this](const Symbol& part) { return is_zero(own(part)); });
}

// Whose number is that of an expression.
void ElementValues::refuse_to_set(const std::string& key, const Symbol& element) const {
  if (quantities_.settings().has(key))
    refuse_expression(scene_, to_text(element), OverridingValues::place(key));
}

void ElementValues::read_scalar(const std::string& name, const ElementUse& use,
                                const toml::node* node) {
  if (expressions_->has({name})) return refuse_to_set(name, {name});
  read_entry({name}, use, node);
}

void ElementValues::read_array(const std::string& name, const ElementUse& use,
                               const toml::node* node) {
  scene_.arrays[own({name}).name] = use.length;
  if (node != nullptr && !node->is_array())
    throw InputError(document::place_of(*node, file_),
                     fmt::format("{} = {}", name, document::describe_node(*node)),
                     fmt::format("an array of {} entries", use.length));
  for (int entry = 1; entry <= use.length; ++entry) {
    const Symbol symbol{name, entry};
    if (networks_.names().is_used(to_text(symbol))) continue;
    if (expressions_->has(symbol)) {
      refuse_to_set(to_text(symbol), symbol);
      continue;
    }
    const auto place = static_cast<std::size_t>(entry - 1);
    complaints_.attempt(
        [&] { read_entry(symbol, use, node == nullptr ? nullptr : node->as_array()->get(place)); });
  }
}

// --set goes before what the scene says and before a stiffness that was typed in.
void ElementValues::read_entry(const Symbol& entry, const ElementUse& use, const toml::node* node) {
  const Symbol symbol = own(entry);
  const std::string label = to_text(entry);
  const auto set = settings().take(label, use.dimension, symbol);
  const TypedNumber* given = set ? &*set : networks_.number_of(entry);
  if (given != nullptr) put(symbol, *given, OverridingValues::place(label));
  if (node == nullptr) return;
  const Place place = document::place_of(*node, file_);
  const auto value = number(*node, use.dimension, label, place);
  if (value && !set) put(symbol, *value, place);
  if (set) quantities_.compare(label, *set, node, use.dimension);
}

void ElementValues::put(const Symbol& symbol, const TypedNumber& number, const Place& place) {
  values_[symbol] = checked(number, nonnegative, to_text(as_called(scene_, symbol)), place);
  scene_.typed[symbol] = number;
}

bool ElementValues::is_zero(const Symbol& symbol) const {
  const auto value = values_.find(symbol);
  return value != values_.end() && value->second == 0;
}

std::optional<double> ElementValues::value(const Symbol& symbol) const {
  const auto value = values_.find(symbol);
  return value == values_.end() ? std::nullopt : std::optional(value->second);
}

}  // namespace vcrit
