#include "scene/changing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/constants.hpp"
#include "base/numbers.hpp"
#include "scene/settings.hpp"

namespace vcrit {

namespace {

// Whether the network stays as it is, and the number is one that the scene may have.
bool fits(const ChangingScene::Target& target, double value) {
  if (target.value == nullptr) return false;
  if (target.is_poisson) return value > -1 && value <= 0.5;
  return value > 0 && std::isfinite(value);
}

}  // namespace

ChangingScene::ChangingScene(const Scene& scene, std::vector<std::string> names)
    : names_(std::move(names)), scene_(scene) {
  std::map<Symbol, std::string> seen;
  for (const std::string& name : names_) {
    known_dimension(name, scene_.settable, OverridingValues::place(name), scene_.named);
    targets_.push_back(target(name));
    const auto [other, is_new] = seen.emplace(targets_.back().symbol, name);
    if (!is_new)
      throw InputError(OverridingValues::place(name),
                       fmt::format("{} as well as {}", name, other->second), "one of the two");
    std::erase_if(scene_.settings, [&](const auto& setting) {
      return target(setting.first).symbol == targets_.back().symbol;
    });
  }
}

ChangingScene::Target ChangingScene::target(const std::string& name) {
  // A scene that was not read from a text has no list of names.
  const auto named = scene_.named.find(name);
  const Symbol symbol = named == scene_.named.end() ? Symbol{name} : named->second;
  Quantity& omega = scene_.angular_frequency;
  if (symbol == frequency_symbol) return {&omega.value, omega.symbol, two_pi};
  if (auto* isotropic = std::get_if<Isotropic>(&scene_.tangential))
    if (isotropic->quantity.symbol == symbol)
      return {&isotropic->quantity.value, symbol, 1, isotropic->by == Isotropic::By::poisson};
  for (Quantity* quantity : quantities(scene_))
    if (quantity->symbol == symbol) return {&quantity->value, symbol};
  for (auto& [element, value] : scene_.elements)
    if (element == symbol || to_text(element) == symbol.name) return {&value, element};
  return {nullptr, symbol};
}

const Scene& ChangingScene::at(std::span<const double> values) {
  if (values.size() != targets_.size())
    throw InputError(argument("values"), fmt::format("{} values", values.size()),
                     fmt::format("{}, one for each name", targets_.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!fits(targets_[i], values[i])) return read_again(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    *targets_[i].value = targets_[i].factor * values[i];
    if (targets_[i].factor != 1) scene_.typed[frequency_symbol] = {values[i], {}};
  }
  return scene_;
}

const Scene& ChangingScene::read_again(std::span<const double> values) {
  Settings settings = scene_.settings;
  for (std::size_t i = 0; i < values.size(); ++i)
    settings.emplace_back(names_[i], to_text(values[i]));
  return read_.emplace(parse_scene(scene_.text, scene_.file, settings));
}

}  // namespace vcrit
