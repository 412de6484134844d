// The cells of a stability map: a scene's numbers over a grid of angular frequencies and factors,
// with v* correctly rounded in each. A resonance or antiresonance is narrow and a grid would miss
// it: in a cell that holds one, omega lies beside it.
#pragma once

#include <functional>
#include <vector>

#include "accuracy/stability.hpp"
#include "network/reduction.hpp"
#include "problem/problem.hpp"

namespace vcrit::validation::accuracy {

struct Cells {
  std::vector<double> omega, factor;  ///< middles of the cells; rad/s, 1
  // A row of one factor after the other:
  std::vector<Values> values;
  std::vector<double> right;  ///< m/s; NaN where v* is 0/0

  double omega_of(std::size_t i) const { return omega[i % omega.size()]; }
  double factor_of(std::size_t i) const { return factor[i / omega.size()]; }
  /// Calls `visit` with the scene of each cell, in order.
  void for_each(const Problem& problem,
                const std::function<void(const Problem& each, std::size_t i)>& visit) const;
};

/// v* correctly rounded, m/s; NaN where it is 0/0.
double certified_or_nan(const Problem& problem);

/// v* correctly rounded of each cell, from its values.
std::vector<double> correctly_rounded(const Problem& problem, const Cells& cells);

/// The amplitude du_z (m), at most that of `values`, at which the normal force keeps a tenth of its
/// mean. A contact without static load stays as it is.
double closed_amplitude(const Problem& problem, const Values& values);

/// By how much, relatively, omega lies beside the resonance or antiresonance of its cell.
constexpr double beside_balance = 1e-8;

Cells cells_of(const Problem& problem, const std::vector<Symbol>& scaled, const MapGrid& grid);

}  // namespace vcrit::validation::accuracy
