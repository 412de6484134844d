// The cells of each kind of extreme: numbers of a scene, and v* there.
#pragma once

#include <string>
#include <vector>

#include "accuracy/cells.hpp"
#include "extremes/families.hpp"

namespace vcrit::validation::extremes {

/// How fine the grids are; tests take coarser ones.
struct Fineness {
  std::size_t omegas = 22, factors = 25;
  std::size_t simulated_every = 2;  ///< column and row of a map
};

struct CellsOf {
  std::string region;
  accuracy::Cells cells;              ///< omega and factor are empty where it is no map
  std::vector<double> distances;      ///< of (anti)resonance, one a cell
  std::vector<std::size_t> approach;  ///< of limits, one a cell: which of the family's
};

/// What the family has of them: no relaxation without dampers, no resonance without a body.
/// Everywhere the amplitude du_z is such that the contact stays closed.
std::vector<CellsOf> all_cells(const Family& family, const Problem& problem,
                               const Fineness& fineness);

}  // namespace vcrit::validation::extremes
