#include "scene/element_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "scene/document.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

namespace {

// A string in the place of an element's value, or of that of an entry of an array.
bool holds_name(const toml::node& value) {
  const auto* array = value.as_array();
  if (array == nullptr) return bare_name(value).has_value();
  return std::any_of(array->begin(), array->end(),
                     [](const toml::node& entry) { return bare_name(entry).has_value(); });
}

}  // namespace

const char* kind_name(const ElementUse& use) {
  return use.length > 0 ? number_row(use.role).several : number_row(use.role).one;
}

void refuse_other_unit(const ElementUse& use, const ElementUse& first, const std::string& what) {
  if (use.dimension == first.dimension) return;
  throw InputError(
      use.place, fmt::format("{} as {}", what, describe(use.dimension)),
      fmt::format("{}, as at {}, or another name", describe(first.dimension), to_text(first.place)),
      "elements of the half-space are in Pa and Pa s, those of the drive in N/m and N "
      "s/m: they need names of their own");
}

ElementNames::ElementNames(const toml::table* elements, std::string file)
    : elements_(elements), file_(std::move(file)) {
  if (elements_ != nullptr)
    any_ = std::any_of(elements_->begin(), elements_->end(),
                       [](const auto& each) { return holds_name(each.second); });
}

// An array's own name under one of its entries says no more than that this has no value.
std::optional<ElementNames::Name> ElementNames::name_under(const Symbol& key) const {
  const toml::node* value = elements_->get(key.name);
  int entry = key.entry;
  if (value != nullptr && value->is_array()) {
    const auto place = static_cast<std::size_t>(entry);
    if (entry == 0 || place > value->as_array()->size()) return std::nullopt;
    value = value->as_array()->get(place - 1);
    entry = 0;
  }
  const auto name = value == nullptr ? std::nullopt : bare_name(*value);
  if (!name || *name == key.name) return std::nullopt;
  return Name{{*name, entry}, document::place_of(*value, file_)};
}

Symbol ElementNames::of(const Symbol& symbol) {
  if (!any_) return symbol;
  Symbol found = symbol;
  std::vector<std::string> way{to_text(symbol)};
  while (const auto name = name_under(found)) {
    used_.insert({found.name, to_text(found)});
    found = name->symbol;
    check_symbol_name(found.name, "an element", name->place);
    const bool circle = std::find(way.begin(), way.end(), to_text(found)) != way.end();
    way.push_back(to_text(found));
    if (circle)
      throw InputError(name->place, fmt::format("names in a circle: {}", joined(way, " = ")),
                       "a value, or a name that is not taken from another element, for one of "
                       "them");
  }
  return found;
}

void ElementNames::note(const Symbol& key, const ElementUse& use, Uses& uses) {
  const Symbol element = of(key);
  origins_[element].push_back(key);
  const auto [known, is_new] =
      uses.try_emplace(element.name, ElementUse{use.role, use.dimension, element.entry, use.place});
  ElementUse& first = known->second;
  if (first.role != use.role || (first.length > 0) != (element.entry > 0))
    throw InputError(
        use.place,
        fmt::format("\"{}\", which [elements] calls {}, as {}", to_text(key), element.name,
                    kind_name({use.role, use.dimension, element.entry, {}})),
        fmt::format("{}, as at {}, or another name", kind_name(first), to_text(first.place)));
  refuse_other_unit(use, first,
                    fmt::format("\"{}\", which [elements] calls {},", to_text(key), element.name));
  first.length = std::max(first.length, element.entry);
}

ElementNames::Uses ElementNames::resolve(const Uses& uses) {
  if (!any_) return uses;
  Uses resolved;
  for (const auto& [name, use] : uses) {
    if (use.length == 0) note({name}, use, resolved);
    for (int entry = 1; entry <= use.length; ++entry) note({name, entry}, use, resolved);
  }
  return resolved;
}

std::map<std::string, Symbol> ElementNames::keys(bool sole) const {
  std::map<std::string, Symbol> found;
  for (const auto& [element, origins] : origins_)
    for (const Symbol& key : origins)
      if (key != element && (origins.size() == 1) == sole) found[to_text(key)] = element;
  return found;
}

}  // namespace vcrit
