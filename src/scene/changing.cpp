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
    known_dimension(name, scene_.settable, OverridingValues::place(name));
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
  const auto of = [](Quantity& quantity) { return Target{&quantity.value, quantity.symbol}; };
  if (name == "frequency")
    return {&scene_.angular_frequency.value, scene_.angular_frequency.symbol, two_pi};
  if (name == "angular_frequency" || name == "omega") return of(scene_.angular_frequency);
  if (name == "amplitude" || name == "du_z") return of(scene_.amplitude);
  if (name == "indentation" || name == "u_z0") return of(scene_.indentation);
  if (name == "coefficient" || name == "mu0") return of(scene_.coefficient);
  if (scene_.mass && (name == "mass" || name == "m")) return of(*scene_.mass);
  if (auto* isotropic = std::get_if<Isotropic>(&scene_.tangential)) {
    const bool poisson = isotropic->by == Isotropic::By::poisson;
    if (name == isotropic->quantity.symbol.name ||
        name == (poisson ? "poisson" : "tangential_ratio"))
      return {&isotropic->quantity.value, isotropic->quantity.symbol, 1, poisson};
  }
  if (scene_.indenter)
    for (Quantity& size : scene_.indenter->sizes)
      if (size.symbol.name == name) return of(size);
  for (auto& [symbol, value] : scene_.elements)
    if (to_text(symbol) == name) return {&value, symbol};
  return {nullptr, {name}};
}

const Scene& ChangingScene::at(std::span<const double> values) {
  ensure(values.size() == targets_.size(), "one value for each name");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!fits(targets_[i], values[i])) return read_again(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    *targets_[i].value = targets_[i].factor * values[i];
  return scene_;
}

const Scene& ChangingScene::read_again(std::span<const double> values) {
  Settings settings = scene_.settings;
  for (std::size_t i = 0; i < values.size(); ++i)
    settings.emplace_back(names_[i], to_text(values[i]));
  return read_.emplace(parse_scene(scene_.text, scene_.file, settings));
}

}  // namespace vcrit
