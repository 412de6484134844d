#include "scene/settings.hpp"

#include <fmt/core.h>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "base/trimmed.hpp"

namespace vcrit {

namespace {

// What the symbol of that name is called in a scene, in short: "M" or "mass" of "m".
std::optional<std::string> named_for(const std::string& name,
                                     const std::map<std::string, Symbol>& named) {
  std::optional<std::string> shortest;
  for (const auto& [given, symbol] : named)
    if (to_text(symbol) == name && (!shortest || given.size() < shortest->size())) shortest = given;
  return shortest;
}

}  // namespace

Dimension known_dimension(const std::string& name, const std::map<std::string, Dimension>& known,
                          const Place& place, const std::map<std::string, Symbol>& named) {
  if (const auto found = known.find(name); found != known.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known_name, dimension] : known) names.push_back(known_name);
  auto meant = named_for(name, named);
  if (!meant) meant = nearest(name, names);
  throw InputError(
      place, fmt::format("\"{}\", which this scene does not have", name),
      meant ? fmt::format("\"{}\"", *meant) : fmt::format("one of {}", joined(names, ", ")));
}

void refuse_expression(const Source& source, const std::string& name, const Place& place) {
  if (const auto table = source.tabulated.find(name); table != source.tabulated.end())
    throw InputError(place, fmt::format("{}, which is in the table {}", name, table->second),
                     "another table, or normal = \"...\", a network of elements to set");
  const auto found = source.expressions.find(name);
  if (found == source.expressions.end()) return;
  throw InputError(place, fmt::format("{}, which is \"{}\" in this scene", name, found->second),
                   "a number that it is made of, or a value in its place in [elements]");
}

std::pair<std::string, std::string> parse_setting(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw InputError(argument("set"), fmt::format("\"{}\"", text), "NAME=VALUE");
  return {std::string(trimmed(text.substr(0, equals), " ")), text.substr(equals + 1)};
}

OverridingValues::OverridingValues(const Settings& settings) {
  for (const auto& [name, text] : settings) settings_[name] = text;
}

Place OverridingValues::place(const std::string& name) { return argument("set " + name); }

std::optional<TypedNumber> OverridingValues::take(const std::string& name, Dimension dimension,
                                                  const Symbol& symbol) {
  known_.emplace(name, dimension);
  named_.emplace(name, symbol);
  const auto setting = settings_.find(name);
  if (setting == settings_.end()) return std::nullopt;
  return parse_typed(setting->second, dimension, place(name));
}

void OverridingValues::refuse_untaken() const {
  for (const auto& [name, text] : settings_) known_dimension(name, known_, place(name), named_);
}

}  // namespace vcrit
