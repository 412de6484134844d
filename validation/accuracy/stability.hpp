// Digits that evaluators lose, and stick that the simulator misses, over twelve decades of
// frequency and of stiffness ratios or relaxation times.
#pragma once

#include "accuracy/data.hpp"
#include "problem/problem.hpp"
#include "run/driver.hpp"

namespace vcrit::validation::accuracy {

struct MapGrid {
  std::size_t omegas = 32, factors = 24;
  double decades = 6;                         ///< to either side of the scene
  std::optional<double> factor_decades = {};  ///< of the factor; none: the same
};

/// Of the 16 that a double has: log10 of the relative error over 2^-53, between 0 and 16. NaN where
/// `found` is not finite.
double digits_lost(double found, double right);

/// What a map may vary. Under a drive network all springs of the contact that the drive does not
/// share, under a rigid one the first spring of the tangential network if there are others. Empty
/// where there is no ratio to vary.
std::vector<Symbol> stiffness_symbols(const Problem& problem);
/// All dampers and relaxation times; empty where nothing relaxes.
std::vector<Symbol> relaxation_symbols(const Problem& problem);

/// The amplitude du_z is reduced in cells where the contact would open: v* is linear in it. Layers:
/// "formula" (Eq. 24 in doubles), "pasted", or where that is not there "complex", and "fast" (with
/// a driver, where it has them), and "simulator" (where the scene can be simulated), whose marks
/// are wrong answers to a speed of 1 +- 1e-6 of the critical one.
StabilityMap stability_map(const Problem& problem, const Driver* driver, const std::string& key,
                           const std::vector<Symbol>& scaled, const MapGrid& grid);

/// The maps that the scene has. What it does not have is said in `left_out`.
std::vector<StabilityMap> stability_maps(const Problem& problem, const Driver* driver,
                                         std::vector<std::string>& left_out);

}  // namespace vcrit::validation::accuracy
