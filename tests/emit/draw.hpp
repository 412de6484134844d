// Random values for scenes of generated code.
#pragma once

#include <cmath>
#include <random>

#include "support/nodal.hpp"
#include "support/numbers.hpp"

namespace vcrit::test {

class Draw {
 public:
  /// The nearest to resonance are off by 10^nearest.
  explicit Draw(unsigned seed, double nearest = -13.0) : random_(seed), nearest_(nearest) {}

  /// A copy of the scene with random values for everything that has none; of kind 1 some far from
  /// all doubles of ordinary size, of kind 2 at resonance but for a relative 1e-1 to 10^nearest.
  Scene values_for(Scene scene, int kind) {
    const double decades = kind == 0 ? 2 : kind == 1 ? 12 : 4;
    const auto give = [&](std::optional<double>& value, double d) {
      if (!value) value = std::pow(10, std::uniform_real_distribution(-d, d)(random_));
    };
    for (auto& [symbol, value] : scene.elements) give(value, decades);
    give(scene.coefficient.value, 1);
    give(scene.angular_frequency.value, decades / 2);
    give(scene.amplitude.value, decades);
    scene.indentation.value = 1.0;
    if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
      if (!isotropic->quantity.value)
        isotropic->quantity.value = std::uniform_real_distribution(0.0, 0.5)(random_);
    if (scene.mass) give(scene.mass->value, decades);
    if (scene.mount_mass && scene.mass && scene.mount_mass->symbol == scene.mass->symbol)
      scene.mount_mass->value = scene.mass->value;
    else if (scene.mount_mass)
      give(scene.mount_mass->value, decades);
    if (scene.mass && kind == 2) near_resonance(scene);
    return scene;
  }

 private:
  void near_resonance(Scene& scene) {
    const Values values = test::numbers_of(scene);
    const Real omega(*scene.angular_frequency.value);
    Real stiffness = Nodal(values, omega).stiffness(*scene.drive).real();
    const auto* tangential = std::get_if<Network>(&scene.tangential);
    if (tangential != nullptr && std::bernoulli_distribution(0.5)(random_))
      stiffness += Nodal(values, omega).stiffness(*tangential).real();
    if (stiffness <= 0) return;
    const double off = std::pow(10, std::uniform_real_distribution(nearest_, -1.0)(random_));
    scene.mass->value = static_cast<double>(stiffness / (omega * omega)) * (1 + off);
  }

  std::mt19937 random_;
  double nearest_;
};

}  // namespace vcrit::test
