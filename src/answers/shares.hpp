// What matters most for v*: by how many per cent it grows where one of its numbers grows by one.
#pragma once

#include <span>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

struct Share {
  Symbol called;  ///< as the scene calls it, without entry where it is a whole array
  Symbol of;      ///< the number itself, the first one of an array
  bool is_array = false;
  double share = 0;  ///< (p/v*) dv*/dp, of an array the sum over its entries
};

/// Those of `symbols` that matter, the largest first; none where v* has no value, or is 0 or
/// infinite.
std::vector<Share> shares_of(const Problem& problem, std::span<const Symbol> symbols);

}  // namespace vcrit
