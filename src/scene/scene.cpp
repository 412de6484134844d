#include "scene/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "network/law.hpp"
#include "scene/members.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

namespace {

void refuse_missing(const Scene& scene, const std::vector<std::string>& missing) {
  if (missing.empty()) return;
  throw InputError({scene.file}, fmt::format("no value for {}", fmt::join(missing, ", ")),
                   "a number for each, in the scene or by --set NAME=VALUE");
}

/// A frequency that has a name is asked for by that.
std::string missing_name(const Scene& scene, const Symbol& symbol) {
  const auto frequency = scene.names.find(frequency_symbol.name);
  if (frequency != scene.names.end() && symbol == scene.angular_frequency.symbol)
    return frequency->second;
  return to_text(as_called(scene, symbol));
}

const Range& range_of(const Scene& scene, const Quantity& quantity) {
  if (&quantity == &scene.angular_frequency || (scene.mass && &quantity == &*scene.mass))
    return positive;
  const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  if (isotropic != nullptr && &quantity == &isotropic->quantity)
    return isotropic->by == Isotropic::By::poisson ? poisson_range : positive;
  return nonnegative;
}

template <class Result, class AnyScene>
std::vector<Result*> quantities_of(AnyScene& scene) {
  std::vector<Result*> all;
  auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  if (isotropic != nullptr && !isotropic->quantity.symbol.name.empty())
    all.push_back(&isotropic->quantity);
  all.insert(all.end(),
             {&scene.coefficient, &scene.angular_frequency, &scene.amplitude, &scene.indentation});
  if (scene.mass) all.push_back(&*scene.mass);
  if (scene.indenter)
    for (Result& size : scene.indenter->sizes) all.push_back(&size);
  return all;
}

}  // namespace

void for_each_element(const Scene& scene, const std::function<void(const Element&)>& visit) {
  for_each_element(scene.normal, visit);
  if (const auto* tangential = std::get_if<Network>(&scene.tangential))
    for_each_element(*tangential, visit);
  if (scene.drive) for_each_element(*scene.drive, visit);
}

std::vector<const Quantity*> quantities(const Scene& scene) {
  return quantities_of<const Quantity>(scene);
}

std::vector<Quantity*> quantities(Scene& scene) { return quantities_of<Quantity>(scene); }

Symbol as_called(const Scene& scene, const Symbol& symbol) {
  const auto name = scene.names.find(symbol.name);
  return name == scene.names.end() ? symbol : Symbol{name->second, symbol.entry};
}

std::string name_in(const Scene& scene, const Quantity& quantity) {
  return to_text(as_called(scene, quantity.symbol));
}

Scene as_doubles(Scene scene) {
  scene.typed.clear();
  return scene;
}

bool has_drive(const Scene& scene) {
  return scene.drive.has_value() || scene.receptance.has_value();
}

double tangential_ratio(const Isotropic& isotropic) {
  if (!isotropic.quantity.value)
    throw InputError(argument(to_text(isotropic.quantity.symbol)), "no value", "a number");
  const double value = *isotropic.quantity.value;
  return isotropic.by == Isotropic::By::poisson ? 2 * (1 - value) / (2 - value) : value;
}

Values values_of(const Scene& scene) {
  Values values;
  std::vector<std::string> missing;
  const auto add = [&](const Symbol& symbol, const std::optional<double>& value,
                       const Range& range) {
    if (value)
      values[symbol] = checked(*value, range, to_text(as_called(scene, symbol)), {scene.file});
    else
      missing.push_back(missing_name(scene, symbol));
  };
  // Reading leaves elements of value 0 out of the networks.
  for (const auto& [symbol, value] : scene.elements) add(symbol, value, positive);
  if (missing.empty()) check_members(scene, values);
  for (const Quantity* quantity : quantities(scene))
    add(quantity->symbol, quantity->value, range_of(scene, *quantity));
  refuse_missing(scene, missing);
  return values;
}

ScaledNetwork tangential_network(const Scene& scene) {
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    return {&scene.normal, tangential_ratio(*isotropic)};
  return {&std::get<Network>(scene.tangential), 1};
}

}  // namespace vcrit
