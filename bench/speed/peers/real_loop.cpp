// The best loop over values that we can write by hand: real and imaginary parts, one division and
// one square root a value. Compiled at run time for VCRIT_SCENE.
#include <cmath>

#include "speed/peers/columns.hpp"
#include "speed/peers/networks.hpp"

namespace by_hand {

namespace {

template <class Access>
[[gnu::always_inline]] inline double velocity(const At<Access>& e) {
  const auto q = Problem::quotient(e);
  return e[0] * e.omega * e[2] *
         std::sqrt(squared(q.over_a) * squared(q.over_b) /
                   (squared(q.under_a) * squared(q.under_b) * squared(q.under_c)));
}

}  // namespace

extern "C" [[gnu::flatten]] void varying(const double* const* x, std::size_t n,
                                         double* __restrict out, double*) {
  const double* __restrict const omega = x[1];
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) out[i] = velocity(At<Varying>{{x, i}, omega[i]});
}

extern "C" [[gnu::flatten]] void sweep(const double* const* x, std::size_t n,
                                       double* __restrict out, double*) {
  const auto values = first_values<Problem::columns>(x);
  const double* __restrict const omega = x[1];
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) out[i] = velocity(At<Fixed>{{values.data()}, omega[i]});
}

}  // namespace by_hand
