// Dimensionless groups as nodes of a program.
#pragma once

#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "program/velocity.hpp"

namespace vcrit::symbolic {

struct Group {
  std::string name;            ///< "beta_m"; of an array's entries together "kappa_k"
  std::string meaning;         ///< "m*omega^2/kd"; of the first entry there is
  std::vector<NodeId> values;  ///< one, or one for each entry of the array
  bool is_array = false;
};

/// The groups that v* depends on, see analysis/dimensionless.hpp. Entries of an array without a
/// group of their own are 1 for the reference, else 0.
std::vector<Group> dimensionless_groups(const Derivation& derivation, Program& program,
                                        const SymbolValue& value);

}  // namespace vcrit::symbolic
