#include "accuracy/resonance.hpp"

#include <cmath>

#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation::accuracy {

Resonances::Resonances(const Scene& scene) : scene_(scene) {
  if (!scene.mass || !scene.drive) return;
  drive_ = reduce(*scene.drive);
  tangential_ = reduce(*tangential_network(scene).network);
}

double Resonances::excess(Balance balance, const Values& values, double omega) const {
  double stiffness = dynamic_stiffness(*drive_, values, omega).real();
  if (balance == Balance::antiresonance)
    stiffness +=
        tangential_network(scene_).factor * dynamic_stiffness(*tangential_, values, omega).real();
  return stiffness - values.at(scene_.mass->symbol) * omega * omega;
}

std::optional<double> Resonances::find(Balance balance, const Values& values) const {
  if (!exist()) return std::nullopt;
  const double omega = values.at(scene_.angular_frequency.symbol);
  double low = 1e-9 * omega, high = 1e9 * omega;
  if (!(excess(balance, values, low) > 0) || !(excess(balance, values, high) < 0))
    return std::nullopt;
  // 18 decades are 2^60 times a rounding error of the first decade.
  for (int i = 0; i < 64; ++i) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (excess(balance, values, middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace vcrit::validation::accuracy
