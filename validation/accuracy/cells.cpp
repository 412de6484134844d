#include "accuracy/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "accuracy/resonance.hpp"
#include "critical/certified.hpp"
#include "normal/mount.hpp"
#include "stiffness/at_rest.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation::accuracy {

namespace {

// Of the mean normal force, at most, in a cell.
constexpr double largest_oscillation = 0.9;

std::vector<double> logarithmic(double middle, double decades, std::size_t size) {
  std::vector<double> result;
  for (std::size_t i = 0; i < size; ++i)
    result.push_back(
        middle *
        std::pow(10, decades * (2 * static_cast<double>(i) / static_cast<double>(size - 1) - 1)));
  return result;
}

/// The column whose cell holds omega; none beside the grid.
std::optional<std::size_t> column_of(const std::vector<double>& middles, double omega) {
  const double step = std::log(middles[1] / middles[0]);
  const double place = std::round(std::log(omega / middles[0]) / step);
  if (!(place >= 0) || place >= static_cast<double>(middles.size())) return std::nullopt;
  return static_cast<std::size_t>(place);
}

/// The angular frequencies of a row, whose other numbers are `values`.
std::vector<double> row_of(const std::vector<double>& middles, const Resonances& resonances,
                           const Values& values) {
  std::vector<double> row = middles;
  for (const ResonanceKind balance : {ResonanceKind::resonance, ResonanceKind::antiresonance})
    if (const auto omega = resonances.find(balance, values))
      if (const auto column = column_of(middles, *omega))
        row[*column] = *omega * (1 + beside_balance);
  return row;
}

}  // namespace

double certified_or_nan(const Problem& problem) {
  try {
    return certified_critical_velocity(problem).value;
  } catch (const ModelError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

double closed_amplitude(const Problem& problem, const Values& values) {
  const Reduction& normal = problem->normal.reduction();
  const double amplitude = values.at(problem->amplitude.symbol);
  const auto stiffness_at_rest = static_cast<double>(at_rest(normal, values).stiffness());
  const double omega = values.at(problem->angular_frequency.symbol);
  if (problem->load)
    return std::min(amplitude,
                    largest_oscillation * values.at(problem->load->symbol) /
                        std::abs(dynamic_stiffness(normal, values, omega)) /
                        (problem->mount ? mount_factor(problem.with(values), omega) : 1));
  if (stiffness_at_rest == 0) return amplitude;
  const double stiffening = stiffness_at_rest / std::abs(dynamic_stiffness(normal, values, omega));
  if (problem->mount)
    return std::min(amplitude, largest_oscillation * stiffening *
                                   values.at(problem->indentation.symbol) /
                                   mount_factor(problem.with(values), omega));
  return std::min(amplitude,
                  largest_oscillation * stiffening * values.at(problem->indentation.symbol));
}

void Cells::for_each(const Problem& problem,
                     const std::function<void(const Problem&, std::size_t)>& visit) const {
  for (std::size_t i = 0; i < values.size(); ++i) visit(problem.with(values[i]), i);
}

std::vector<double> correctly_rounded(const Problem& problem, const Cells& cells) {
  std::vector<double> right;
  cells.for_each(
      problem, [&](const Problem& each, std::size_t) { right.push_back(certified_or_nan(each)); });
  return right;
}

Cells cells_of(const Problem& problem, const std::vector<Symbol>& scaled, const MapGrid& grid) {
  const Values& base = problem.values();
  const Resonances resonances(problem);
  Cells cells;
  cells.omega = logarithmic(base.at(problem->angular_frequency.symbol), grid.decades, grid.omegas);
  cells.factor = logarithmic(1, grid.factor_decades.value_or(grid.decades), grid.factors);
  for (const double factor : cells.factor) {
    Values values = base;
    for (const Symbol& symbol : scaled) values[symbol] = factor * base.at(symbol);
    for (const double omega : row_of(cells.omega, resonances, values)) {
      values[problem->angular_frequency.symbol] = omega;
      values[problem->amplitude.symbol] = base.at(problem->amplitude.symbol);
      values[problem->amplitude.symbol] = closed_amplitude(problem, values);
      cells.values.push_back(values);
    }
  }
  cells.right = correctly_rounded(problem, cells);
  return cells;
}

}  // namespace vcrit::validation::accuracy
