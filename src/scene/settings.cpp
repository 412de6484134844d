#include "scene/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/identifiers.hpp"

namespace vcrit {

OverridingValues::OverridingValues(const Settings& settings) {
  for (const auto& [name, text] : settings) settings_[name] = text;
}

Place OverridingValues::place(const std::string& name) { return {"--set " + name}; }

std::optional<double> OverridingValues::take(const std::string& name, Dimension dimension) {
  known_.emplace(name, dimension);
  const auto setting = settings_.find(name);
  if (setting == settings_.end()) return std::nullopt;
  return parse_quantity(setting->second, dimension, place(name));
}

void OverridingValues::refuse_untaken() const {
  std::vector<std::string> known;
  for (const auto& [name, dimension] : known_) known.push_back(name);
  for (const auto& [name, text] : settings_) {
    if (known_.contains(name)) continue;
    const auto meant = nearest(name, known);
    throw InputError(
        place(name), fmt::format("\"{}\", which this scene does not have", name),
        meant ? fmt::format("\"{}\"", *meant) : fmt::format("one of {}", fmt::join(known, ", ")));
  }
}

}  // namespace vcrit
