// The numbers of a scene as they are, also those that no scene may have: evaluators are given them
// on purpose, and must say what they are worth.
#pragma once

#include "scene/scene.hpp"

namespace vcrit::test {

/// Those without a value are left out.
inline Values numbers_of(const Scene& scene) {
  Values numbers;
  for (const auto& [symbol, value] : scene.elements)
    if (value) numbers[symbol] = *value;
  const auto add = [&numbers](const Quantity& quantity) {
    if (quantity.value) numbers[quantity.symbol] = *quantity.value;
  };
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential)) add(isotropic->quantity);
  for (const Quantity& quantity :
       {scene.coefficient, scene.angular_frequency, scene.amplitude, scene.indentation})
    add(quantity);
  if (scene.mass) add(*scene.mass);
  if (scene.mount_mass) add(*scene.mount_mass);
  if (scene.indenter)
    for (const Quantity& size : scene.indenter->sizes) add(size);
  return numbers;
}

}  // namespace vcrit::test
