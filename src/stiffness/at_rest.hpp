// What a network does as an oscillation becomes ever slower: K(s) ~ coefficient s^order, s -> 0.
// Nothing cancels in it, so it is right to a few rounding errors a step, and found without the
// relaxation times.
#pragma once

#include "network/reduction.hpp"

namespace vcrit {

struct AtRest {
  int order =
      0;  ///< 0: a spring carries a steady load; 1: a damper creeps; 2: a mass yields freely
  /// N/m, N s/m or kg. Wide in range: products of values of all orders pass through it.
  long double coefficient = 0;

  long double stiffness() const { return order == 0 ? coefficient : 0; }
  /// 1/eta of a network that creeps, else 0.
  long double fluidity() const { return order == 1 ? 1 / coefficient : 0; }
};

AtRest at_rest(const Reduction& reduction, const Values& values);

}  // namespace vcrit
