#include "extremes/regions.hpp"

#include <cmath>

#include "accuracy/resonance.hpp"
#include "network/law.hpp"

namespace vcrit::validation::extremes {

using accuracy::Balance;

namespace {

constexpr double omega_decades = 10.5, relaxation_decades = 12, stiffness_decades = 30;
constexpr double limits_omega = 1;  // rad/s, of the same size as all other numbers

void close_contact(const Scene& scene, Values& values) {
  double& amplitude = values[scene.amplitude.symbol];
  amplitude = accuracy::closed_amplitude(scene, reduce(scene.normal), values);
}

CellsOf finished(const Scene& scene, CellsOf made) {
  for (Values& values : made.cells.values) close_contact(scene, values);
  made.cells.right = accuracy::correctly_rounded(scene, made.cells);
  return made;
}

void add_map(std::vector<CellsOf>& all, const Scene& scene, const char* key,
             const std::vector<Symbol>& scaled, double decades, const Fineness& fineness) {
  if (scaled.empty()) return;
  const accuracy::MapGrid grid{fineness.omegas, fineness.factors, omega_decades, decades};
  all.push_back({key, accuracy::cells_of(scene, scaled, grid), {}, {}});
}

std::vector<Symbol> springs_of_drive(const Scene& scene) {
  std::vector<Symbol> springs;
  for_each_element(*scene.drive, [&](const Element& element) {
    if (is_elastic(element)) springs.push_back(element.coefficient);
  });
  return springs;
}

CellsOf corners(const Scene& scene, const std::vector<double>& omegas) {
  CellsOf made{"corners", {}, {}, {}};
  const double end = std::pow(10, stiffness_decades);
  for (const double contact : {1 / end, end})
    for (const double drive : {1 / end, end})
      for (const double omega : omegas) {
        Values values = values_of(scene);
        for (const Symbol& symbol : accuracy::stiffness_symbols(scene)) values[symbol] *= contact;
        for (const Symbol& symbol : springs_of_drive(scene)) values[symbol] *= drive;
        values[scene.angular_frequency.symbol] = omega;
        made.cells.values.push_back(values);
      }
  return finished(scene, made);
}

/// 1e-1 to 1e-15 on both sides, from far below over 0 to far above.
std::vector<double> distances() {
  std::vector<double> all;
  for (int i = 1; i <= 15; ++i) all.push_back(-std::pow(10, -i));
  all.push_back(0);
  for (int i = 15; i >= 1; --i) all.push_back(std::pow(10, -i));
  return all;
}

void add_balance(std::vector<CellsOf>& all, const Scene& scene, const char* key, Balance balance) {
  const accuracy::Resonances resonances(scene);
  Values values = values_of(scene);
  values[scene.angular_frequency.symbol] = limits_omega;
  const auto place = resonances.find(balance, values);
  if (!place) return;
  CellsOf made{key, {}, distances(), {}};
  // Bisection ends some ulp beside a balance that is a short number, as those of most families are.
  const double near = std::nearbyint(0x1p20 * *place) * 0x1p-20;
  const double exact = std::abs(near - *place) < 0x1p-48 * near ? near : *place;
  for (const double distance : made.distances) {
    values[scene.angular_frequency.symbol] = exact * (1 + distance);
    values[scene.amplitude.symbol] = *scene.amplitude.value;
    made.cells.values.push_back(values);
  }
  all.push_back(finished(scene, made));
}

/// 1e-3 to 1e-300, or 1e3 to 1e300.
std::vector<double> approaching(Approach::To to) {
  std::vector<double> all;
  for (const double exponent : {3, 6, 9, 12, 15, 30, 100, 200, 300})
    all.push_back(std::pow(10, to == Approach::To::zero ? -exponent : exponent));
  return all;
}

CellsOf approaches(const Family& family, const Scene& scene) {
  CellsOf made{"limits", {}, {}, {}};
  for (std::size_t i = 0; i < family.approaches.size(); ++i)
    for (const double value : approaching(family.approaches[i].to)) {
      Values values = values_of(scene);
      values[scene.angular_frequency.symbol] = limits_omega;
      values[family.approaches[i].what] = value;
      made.cells.values.push_back(values);
      made.approach.push_back(i);
    }
  return finished(scene, made);
}

}  // namespace

std::vector<CellsOf> all_cells(const Family& family, const Scene& scene, const Fineness& fineness) {
  std::vector<CellsOf> all;
  add_map(all, scene, "relaxation", accuracy::relaxation_symbols(scene), relaxation_decades,
          fineness);
  add_map(all, scene, "stiffness", accuracy::stiffness_symbols(scene), stiffness_decades, fineness);
  if (scene.drive && !all.empty()) all.push_back(corners(scene, all.front().cells.omega));
  add_balance(all, scene, "resonance", Balance::resonance);
  add_balance(all, scene, "antiresonance", Balance::antiresonance);
  if (!family.approaches.empty()) all.push_back(approaches(family, scene));
  return all;
}

}  // namespace vcrit::validation::extremes
