#include "extremes/regions.hpp"

#include <cmath>

#include "accuracy/resonance.hpp"
#include "network/law.hpp"

namespace vcrit::validation::extremes {

using accuracy::ResonanceKind;

namespace {

constexpr double omega_decades = 10.5, relaxation_decades = 12, stiffness_decades = 30;
constexpr double limits_omega = 1;  // rad/s, of the same size as all other numbers

void close_contact(const Problem& problem, Values& values) {
  double& amplitude = values[problem->amplitude.symbol];
  amplitude = accuracy::closed_amplitude(problem, values);
}

CellsOf finished(const Problem& problem, CellsOf made) {
  for (Values& values : made.cells.values) close_contact(problem, values);
  made.cells.right = accuracy::correctly_rounded(problem, made.cells);
  return made;
}

void add_map(std::vector<CellsOf>& all, const Problem& problem, const char* key,
             const std::vector<Symbol>& scaled, double decades, const Fineness& fineness) {
  if (scaled.empty()) return;
  const accuracy::MapGrid grid{fineness.omegas, fineness.factors, omega_decades, decades};
  all.push_back({key, accuracy::cells_of(problem, scaled, grid), {}, {}});
}

std::vector<Symbol> springs_of_drive(const Problem& problem) {
  std::vector<Symbol> springs;
  for_each_element(problem->drive_network()->network(), [&](const Element& element) {
    if (is_elastic(element)) springs.push_back(element.coefficient.symbol());
  });
  return springs;
}

CellsOf corners(const Problem& problem, const std::vector<double>& omegas) {
  CellsOf made{"corners", {}, {}, {}};
  const double end = std::pow(10, stiffness_decades);
  for (const double contact : {1 / end, end})
    for (const double drive : {1 / end, end})
      for (const double omega : omegas) {
        Values values = problem.values();
        for (const Symbol& symbol : accuracy::stiffness_symbols(problem)) values[symbol] *= contact;
        for (const Symbol& symbol : springs_of_drive(problem)) values[symbol] *= drive;
        values[problem->angular_frequency.symbol] = omega;
        made.cells.values.push_back(values);
      }
  return finished(problem, made);
}

/// 1e-1 to 1e-15 on both sides, from far below over 0 to far above.
std::vector<double> distances() {
  std::vector<double> all;
  for (int i = 1; i <= 15; ++i) all.push_back(-std::pow(10, -i));
  all.push_back(0);
  for (int i = 15; i >= 1; --i) all.push_back(std::pow(10, -i));
  return all;
}

void add_balance(std::vector<CellsOf>& all, const Problem& problem, const char* key,
                 ResonanceKind balance) {
  const accuracy::Resonances resonances(problem);
  Values values = problem.values();
  values[problem->angular_frequency.symbol] = limits_omega;
  const auto place = resonances.find(balance, values);
  if (!place) return;
  CellsOf made{key, {}, distances(), {}};
  // Bisection ends some ulp beside a balance that is a short number, as those of most families are.
  const double near = std::nearbyint(0x1p20 * *place) * 0x1p-20;
  const double exact = std::abs(near - *place) < 0x1p-48 * near ? near : *place;
  for (const double distance : made.distances) {
    values[problem->angular_frequency.symbol] = exact * (1 + distance);
    values[problem->amplitude.symbol] = *problem->amplitude.value;
    made.cells.values.push_back(values);
  }
  all.push_back(finished(problem, made));
}

/// 1e-3 to 1e-300, or 1e3 to 1e300.
std::vector<double> approaching(Approach::To to) {
  std::vector<double> all;
  for (const double exponent : {3, 6, 9, 12, 15, 30, 100, 200, 300})
    all.push_back(std::pow(10, to == Approach::To::zero ? -exponent : exponent));
  return all;
}

CellsOf approaches(const Family& family, const Problem& problem) {
  CellsOf made{"limits", {}, {}, {}};
  for (std::size_t i = 0; i < family.approaches.size(); ++i)
    for (const double value : approaching(family.approaches[i].to)) {
      Values values = problem.values();
      values[problem->angular_frequency.symbol] = limits_omega;
      values[family.approaches[i].what] = value;
      made.cells.values.push_back(values);
      made.approach.push_back(i);
    }
  return finished(problem, made);
}

}  // namespace

std::vector<CellsOf> all_cells(const Family& family, const Problem& problem,
                               const Fineness& fineness) {
  std::vector<CellsOf> all;
  add_map(all, problem, "relaxation", accuracy::relaxation_symbols(problem), relaxation_decades,
          fineness);
  add_map(all, problem, "stiffness", accuracy::stiffness_symbols(problem), stiffness_decades,
          fineness);
  if (!problem->rigid() && !all.empty()) all.push_back(corners(problem, all.front().cells.omega));
  add_balance(all, problem, "resonance", ResonanceKind::resonance);
  add_balance(all, problem, "antiresonance", ResonanceKind::antiresonance);
  if (!family.approaches.empty()) all.push_back(approaches(family, problem));
  return all;
}

}  // namespace vcrit::validation::extremes
