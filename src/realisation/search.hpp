// The structure for a table: of each order and each form of damping the best of ten starts, and of
// these the one that Schwarz's criterion prefers.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "realisation/starts.hpp"
#include "realisation/structure.hpp"

namespace vcrit::realisation {

struct Candidate {
  StructureShape shape;
  Eigen::VectorXd parameters;
  double sum = 0;        ///< of squares of relative misfits, over all rows
  double criterion = 0;  ///< of Schwarz
};

struct FoundStructures {
  Candidate best;
  /// The others of its order, of one more and one less that the misfit allows.
  std::vector<Candidate> rivals;
};

/// `noise`: of real and imaginary part each, relative, below which no misfit says anything;
/// `order`: the modes that the structure is to have, where it is given; `most_general`: what its
/// damping may be. Throws InputError for an order that the rows cannot hold.
FoundStructures search(const Rows& rows, double noise, std::optional<Eigen::Index> order,
                       Damping most_general);

/// From these parameters on, over these rows.
Candidate refined(const Rows& rows, const StructureShape& shape, const Eigen::VectorXd& parameters,
                  int steps);

constexpr Eigen::Index most_fitted_modes = 8;  ///< where the order is not given

}  // namespace vcrit::realisation
