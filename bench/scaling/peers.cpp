#include "scaling/peers.hpp"

#include "harness/timing.hpp"
#include "scaling/libraries.hpp"
#include "scaling/own.hpp"
#include "scaling/scripts.hpp"

namespace vcrit::scaling {

double seconds_of(const std::function<void()>& run) { return bench::settled_time(run, 0.1); }

std::vector<ScalingPeer> nested_peers() {
  return {{"vcrit, straight line", straight_line},
          {"vcrit, named formula", named_formula},
          {"GiNaC, composed", ginac_composed},
          {"SymPy, composed", sympy_composed}};
}

std::vector<ScalingPeer> expanded_peers() {
  return {{"vcrit", multiplied_out},
          {"FLINT, by hand", flint_by_hand},
          {"Maxima, newdet", maxima_newdet},
          {"GiNaC, determinant", ginac_determinant},
          {"GiNaC, lsolve + normal", ginac_lsolve},
          {"SymPy, field", sympy_field},
          {"SymPy, cancel", sympy_cancel}};
}

}  // namespace vcrit::scaling
