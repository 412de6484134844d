#include "scene/quantities.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "base/constants.hpp"

namespace vcrit {

const Range nonnegative{[](double v) { return std::isfinite(v) && v >= 0; },
                        "a finite value of at least 0"};
const Range positive{[](double v) { return std::isfinite(v) && v > 0; }, "a finite value above 0"};
const Range poisson_range{[](double v) { return v > -1 && v <= 0.5; },
                          "a Poisson's ratio above -1, up to 0.5"};
const Range slope_range{[](double v) { return v > 0 && v < pi / 2; },
                        "an angle between 0 and 90 deg"};

double checked(double value, const Range& range, const std::string& name, const Place& place) {
  if (range.holds(value)) return value;
  throw InputError(place, fmt::format("{} = {}", name, value), range.expected);
}

std::optional<TypedNumber> number(const toml::node& node, Dimension dimension,
                                  const std::string& name, const Place& place) {
  // Not node.value<double>(), which has none for an integer that no double equals.
  if (node.is_integer()) return TypedNumber{static_cast<double>(node.ref<std::int64_t>()), {}};
  if (node.is_floating_point()) return TypedNumber{node.ref<double>(), {}};
  if (!node.is_string())
    throw InputError(place, fmt::format("{} = {}", name, document::describe_node(node)),
                     describe(dimension));
  const auto& text = node.ref<std::string>();
  const auto word = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  const bool bare = !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
                    std::all_of(text.begin(), text.end(), word) && text != "inf" && text != "nan";
  if (bare) return std::nullopt;
  return parse_typed(text, dimension, place);
}

void refuse_other_name(const toml::node& node, std::initializer_list<std::string> own,
                       const std::string& name, const Place& place, const std::string& expected) {
  const auto* text = node.as_string();
  if (text != nullptr && std::find(own.begin(), own.end(), text->get()) == own.end())
    throw InputError(place, fmt::format("{} = \"{}\"", name, text->get()), expected);
}

Quantity Quantities::read(const document::Section& section, const char* key,
                          const std::string& symbol, Dimension dimension, const Range& range) {
  Quantity quantity{{symbol}, std::nullopt};
  if (key != symbol) refuse_both(key, symbol);
  for (const std::string& name : {std::string(key), symbol})
    if (const auto value = settings_.take(name, dimension)) {
      quantity.value = checked(value->value, range, name, OverridingValues::place(name));
      typed_[{symbol}] = *value;
    }
  const toml::node* node = section.find(key);
  if (node == nullptr) return quantity;
  const auto value = number(*node, dimension, key, section.place(key));
  if (!value)
    refuse_other_name(*node, {symbol, key}, key, section.place(key),
                      fmt::format("a value, or \"{}\", which is its name in formulas", symbol));
  if (!value) return quantity;
  checked(value->value, range, key, section.place(key));
  if (quantity.value) return quantity;
  quantity.value = value->value;
  typed_[{symbol}] = *value;
  return quantity;
}

void Quantities::refuse_both(const std::string& name, const std::string& other) const {
  if (settings_.has(name) && settings_.has(other))
    throw InputError(OverridingValues::place(other), fmt::format("{} as well as {}", other, name),
                     "one of the two");
}

}  // namespace vcrit
