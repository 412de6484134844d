#include "answers/closed_share.hpp"

#include <algorithm>
#include <utility>

#include "network/graph.hpp"
#include "scene/changing.hpp"

namespace vcrit {

namespace {

// No element of a scene has this name.
const Symbol unit_spring{"1", 0};

Scene rigidly_driven(Scene scene, const Network& normal) {
  scene.normal = normal;
  scene.tangential = spring(unit_spring);
  scene.elements.emplace_back(unit_spring, 1.0);
  scene.drive.reset();
  scene.receptance.reset();
  scene.mass.reset();
  scene.indenter.reset();
  scene.separation = false;
  scene.coefficient.value = scene.amplitude.value = scene.indentation.value = 1;
  return scene;
}

}  // namespace

ClosedShare::Modulus ClosedShare::modulus(const Scene& scene, const Network& normal,
                                          const std::vector<std::string>& varying) {
  const std::vector<Symbol> symbols = symbols_of(normal);
  std::vector<std::string> names;
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < varying.size(); ++i) {
    const Symbol symbol = ChangingScene(scene, {varying[i]}).targets().front().symbol;
    const bool moves = std::find(symbols.begin(), symbols.end(), symbol) != symbols.end() ||
                       symbol == scene.angular_frequency.symbol;
    if (!moves) continue;
    names.push_back(varying[i]);
    columns.push_back(i);
  }
  return {CriticalVelocities(rigidly_driven(scene, normal), std::move(names)), std::move(columns)};
}

void ClosedShare::Modulus::operator()(std::span<const std::span<const double>> all,
                                      std::span<double> out) const {
  std::vector<std::span<const double>> chosen;
  for (const std::size_t column : columns) chosen.push_back(all[column]);
  velocities(chosen, out);
}

ClosedShare::ClosedShare(const Scene& scene, const std::vector<std::string>& varying)
    : oscillating_(modulus(scene, scene.normal, varying)) {
  const auto springs = springs_alone(scene.normal);
  if (springs) at_rest_ = modulus(scene, *springs, varying);
}

void ClosedShare::operator()(std::span<const std::span<const double>> columns,
                             std::span<double> out) const {
  std::fill(out.begin(), out.end(), 0.0);
  if (!at_rest_) return;
  std::vector<double> oscillating(out.size());
  oscillating_(columns, oscillating);
  (*at_rest_)(columns, out);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] /= oscillating[i];
}

}  // namespace vcrit
