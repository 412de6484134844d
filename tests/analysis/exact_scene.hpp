// A scene's values as exact numbers, and v* of the independent nodal evaluation as one.
#pragma once

#include <cmath>
#include <map>

#include "formula/symbols.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"

namespace vcrit::test {

inline std::map<Symbol, GiNaC::numeric> exact_values(const Scene& scene) {
  std::map<Symbol, GiNaC::numeric> values;
  for (const auto& [symbol, value] : values_of(scene))
    values[symbol] = symbolic::exact_binary(value);
  return values;
}

/// Decimals of doubles with few bits are those doubles, so that the fraction that the derivation
/// reads and the double that the nodal evaluation takes are one number.
inline void round_ratio(Scene& scene) {
  if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    isotropic->quantity.value = std::ceil(*isotropic->quantity.value * 64) / 128;
}

inline GiNaC::numeric number(const Real& value) {
  return GiNaC::numeric(value.str(120, std::ios::scientific).c_str());
}

/// Digits in which two numbers agree.
inline double agreement(const GiNaC::numeric& a, const GiNaC::numeric& b) {
  if (a.is_equal(b)) return 1000;
  return -(GiNaC::log(GiNaC::abs((a - b) / b)) / GiNaC::log(GiNaC::numeric(10))).to_double();
}

}  // namespace vcrit::test
