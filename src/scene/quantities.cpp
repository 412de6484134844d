#include "scene/quantities.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "base/spelled_names.hpp"
#include "scene/new_scene.hpp"

namespace vcrit {

namespace {

// Keys of the scene file that commands take as names, and what --over varies beside them.
const std::set<std::string>& keys() {
  static const std::set<std::string> all{"amplitude", "angular_frequency", "coefficient",
                                         "force",     "frequency",         "indentation",
                                         "mass",      "poisson",           "tangential_ratio",
                                         "velocity",  "velocity_ratio"};
  return all;
}

// No name of a scene has this character.
constexpr char other_mark = '~';

}  // namespace

std::optional<TypedNumber> number(const toml::node& node, Dimension dimension,
                                  const std::string& name, const Place& place) {
  // Not node.value<double>(), which has none for an integer that no double equals.
  if (node.is_integer())
    return TypedNumber{static_cast<double>(node.ref<std::int64_t>()), {}, true};
  if (node.is_floating_point()) return TypedNumber{node.ref<double>(), {}, true};
  if (!node.is_string())
    throw InputError(place, fmt::format("{} = {}", name, document::describe_node(node)),
                     describe(dimension));
  if (bare_name(node)) return std::nullopt;
  if (node.ref<std::string>() == to_be_filled_in)
    throw InputError(place, fmt::format("{} = \"{}\"", name, to_be_filled_in), describe(dimension),
                     fmt::format("{} still has its question mark: put its value there", name));
  const auto& text = node.ref<std::string>();
  // A value begins with its number.
  if (!text.empty() && name_beyond_ascii(text, 0) == text) refuse_name_beyond_ascii(text, 0, place);
  return parse_typed(text, dimension, place);
}

std::optional<std::string> bare_name(const toml::node& node) {
  if (!node.is_string()) return std::nullopt;
  const auto& text = node.ref<std::string>();
  const auto word = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  const bool bare = !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
                    std::all_of(text.begin(), text.end(), word) && text != "inf" && text != "nan";
  return bare ? std::optional(text) : std::nullopt;
}

void check_name(const char* what, const std::string& name, const Place& place) {
  refuse_name_beyond_ascii(name, 0, place);
  if (const auto why = unsafe_as_identifier(name))
    throw InputError(place, fmt::format("{} \"{}\", a name that {}", what, name, *why),
                     "another name");
}

void check_symbol_name(const std::string& name, const char* what, const Place& place,
                       const std::set<std::string>& taken) {
  refuse_name_beyond_ascii(name, 0, place);
  if (const auto why = unsafe_as_identifier(name))
    throw InputError(place, fmt::format("name \"{}\", which {}", name, *why), "another name");
  if (!taken.contains(name) && !keys().contains(name)) return;
  std::set<std::string> all = taken;
  all.insert(keys().begin(), keys().end());
  throw InputError(
      place, fmt::format("\"{}\" as {}", name, what),
      fmt::format("another name: it is a quantity of the scene ({})", joined(all, ", ")));
}

std::string own_name_of(const std::string& name, const std::set<std::string>& others) {
  static const std::set<std::string> quantities{"mu0", "omega", "du_z", "u_z0"};
  return quantities.contains(name) || others.contains(name) ? name + other_mark : name;
}

Quantity Quantities::read(const document::Section& section, const char* key,
                          const std::string& symbol, Dimension dimension, const Range& range) {
  return read(section, key, symbol, dimension, range, {});
}

Quantity Quantities::read(const document::Section& section, const char* key,
                          const std::string& symbol, Dimension dimension, const Range& range,
                          const Called& called) {
  Quantity quantity{{symbol}, std::nullopt};
  complaints_.attempt([&] { read_value(quantity, section, key, dimension, range, called); });
  return quantity;
}

void Quantities::read_value(Quantity& quantity, const document::Section& section, const char* key,
                            Dimension dimension, const Range& range, const Called& called) {
  const Symbol& symbol = quantity.symbol;
  const toml::node* node = section.find(key);
  const auto given = node == nullptr ? std::nullopt : bare_name(*node);
  const std::string name = given.value_or(called.name.empty() ? symbol.name : called.name);
  const std::string setting = called.setting.empty() ? key : called.setting;
  if (given && *given != key) check_symbol_name(*given, "a symbol", section.place(key));
  read_.push_back({setting, symbol.name, name, section.place(key)});
  if (setting != name) refuse_both(setting, name);
  // Where both are one name, a setting of it is one number.
  for (const std::string& either : std::set<std::string>{setting, name})
    if (const auto value = settings_.take(either, dimension, symbol)) {
      quantity.value = checked(*value, range, either, OverridingValues::place(either));
      note(symbol, key, *value, {});
      compare(key, *value, node, dimension);
    }
  if (node == nullptr || given) return;
  const auto value = number(*node, dimension, key, section.place(key));
  if (!value) return;
  checked(*value, range, key, section.place(key));
  if (quantity.value) return;
  quantity.value = value->value;
  note(symbol, key, *value, section.place(key));
}

void Quantities::note(const Symbol& symbol, const char* key, const TypedNumber& number,
                      const Place& place) {
  typed_[symbol] = number;
  if (number.is_bare)
    bare_.push_back({key, number.value, place});
  else
    gives_units_ = true;
}

void Quantities::compare(const std::string& name, const TypedNumber& set, const toml::node* node,
                         Dimension dimension) {
  if (!set.is_bare || node == nullptr || !node->is_string() || bare_name(*node)) return;
  const std::string unit = nearer_unit(set.value, node->ref<std::string>(), dimension);
  if (unit.empty()) return;
  gives_units_ = true;
  const auto noted = std::find_if(bare_.begin(), bare_.end(), [&](const BareNumber& it) {
    return it.key == name && it.unit.empty() && it.value == set.value;
  });
  const BareNumber number{name, set.value, {}, unit, dimension};
  if (noted == bare_.end())
    bare_.push_back(number);
  else
    *noted = number;
}

std::vector<Warning> Quantities::warnings() const {
  return gives_units_ ? suspicious_bare_numbers(bare_) : std::vector<Warning>{};
}

void Quantities::refuse_equal_names() const {
  for (const Named& one : read_)
    for (const Named& other : read_)
      if (&one != &other && one.name != one.symbol &&
          (one.name == other.name || one.name == other.key))
        throw InputError(one.place, fmt::format("{} = \"{}\"", one.key, one.name),
                         fmt::format("another name: {} is called so", other.key));
}

std::map<std::string, std::string> Quantities::names() const {
  std::map<std::string, std::string> all;
  for (const Named& one : read_)
    if (one.name != one.symbol) all[one.symbol] = one.name;
  return all;
}

void Quantities::refuse_both(const std::string& name, const std::string& other) const {
  if (settings_.has(name) && settings_.has(other))
    throw InputError(OverridingValues::place(other), fmt::format("{} as well as {}", other, name),
                     "one of the two");
}

}  // namespace vcrit
