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
  for (const Quantity* quantity : quantities(scene))
    if (quantity->value) numbers[quantity->symbol] = *quantity->value;
  return numbers;
}

}  // namespace vcrit::test
