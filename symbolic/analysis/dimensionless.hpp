// v* in dimensionless groups: kappa = k_i/k, theta = omega c_j/k or omega tau_j, beta = m
// omega^2/k. What has the dimension of a stiffness is measured in one reference; each damper in the
// spring beside it, so that theta is omega times a relaxation or retardation time of the network.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "derivation/derivation.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// The groups of a scene, and what its symbols are in them with reference and omega put to 1.
struct DimensionlessGroups {
  GiNaC::exmap scale;
  std::vector<Line> lines;  ///< each group in the scene's symbols
};

DimensionlessGroups dimensionless_groups(const Problem& problem);

struct DimensionlessForm {
  std::vector<Line> groups;       ///< each group in the scene's symbols; only those that v* holds
  std::vector<Line> definitions;  ///< K_1, ..., K_n over the reference, with s = i
  Expression velocity;            ///< v*/(mu0 omega du_z)
};

DimensionlessForm dimensionless(const Derivation& derivation);

}  // namespace vcrit::symbolic
