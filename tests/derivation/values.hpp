// Exact values for the symbols of scenes.
#pragma once

#include <ginac/ginac.h>

#include <cmath>
#include <map>

#include "formula/symbols.hpp"
#include "problem/problem.hpp"
#include "scene/scene.hpp"

namespace vcrit::test {

using ExactValues = std::map<Symbol, GiNaC::numeric>;

/// The fractions that the scene's doubles are.
inline ExactValues exact_values(const Scene& scene) {
  ExactValues values;
  for (const auto& [symbol, value] : resolve(scene).values())
    values[symbol] = symbolic::exact_binary(value);
  return values;
}

/// Decimals of doubles with few bits are those doubles, so that the fraction that the derivation
/// reads and the double that the nodal evaluation takes are one number.
inline void round_ratio(Scene& scene) {
  if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    isotropic->quantity.value = std::ceil(*isotropic->quantity.value * 64) / 128;
}

/// Values of one size for a scene without values.
inline ExactValues some_values(const Scene& scene) {
  ExactValues values{{{"mu0"}, GiNaC::numeric(3, 10)}, {{"omega"}, GiNaC::numeric(7, 3)},
                     {{"du_z"}, GiNaC::numeric(1, 7)}, {{"m"}, GiNaC::numeric(11, 13)},
                     {{"nu"}, GiNaC::numeric(2, 7)},   {{"r"}, GiNaC::numeric(3, 5)}};
  int count = 0;
  for (const auto& [symbol, value] : scene.elements)
    values[symbol] = GiNaC::numeric(17 + 5 * count++, 19);
  return values;
}

}  // namespace vcrit::test
