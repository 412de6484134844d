// The relaxation form of a spring-damper network: however wired, it acts on its terminals like an
// equilibrium spring, a direct damper and Maxwell branches in parallel,
//   K(s) = k_inf + c_inf s + sum_j k_j s/(s + 1/tau_j),   all k_j > 0, tau_j > 0 real.
// Its dual, the retardation form, is a glassy spring, a free damper and Kelvin units in series,
//   1/K(s) = J_g + phi/s + sum_j psi_j/(s + beta_j).
#pragma once

#include <complex>
#include <vector>

#include "network/network.hpp"
#include "stiffness/secular.hpp"

namespace vcrit {

struct MaxwellBranch {
  double stiffness = 0;  ///< k_j > 0 (N/m)
  double time = 0;       ///< tau_j > 0 (s)
};

struct Relaxation {
  double equilibrium = 0;               ///< k_inf (N/m), 0 for a fluid-like network
  double damper = 0;                    ///< c_inf (N s/m)
  std::vector<MaxwellBranch> branches;  ///< by increasing time, times all different
};

/// The relaxation form of a network whose elements all have positive values. Relative error of
/// K(i omega): a few rounding errors an element at any omega. Throws InputError for other values,
/// and for a network with masses or that is none (wiring.hpp).
Relaxation relaxation_form(const Network& network, const Values& values);

/// K(i omega) of the form.
std::complex<double> dynamic_stiffness(const Relaxation& relaxation, double omega);

/// All stiffnesses and dampers times `factor`.
Relaxation scaled(Relaxation relaxation, double factor);

/// Side by side, and one behind the other. Throw InputError unless there is one at least.
Relaxation parallel(const std::vector<Relaxation>& parts);
Relaxation series(const std::vector<Relaxation>& parts);

/// direct + sum_j weight_j/(s + rate_j), rates increasing from >= 0, weights > 0: K(s)/s of a
/// network (direct: c_inf; rate 0: k_inf) or 1/K(s) (direct: J_g; rate 0: the free damper 1/eta).
struct PoleSum {
  double direct = 0;
  std::vector<double> rates;
  std::vector<double> weights;
};

PoleSum stiffness_poles(const Relaxation& relaxation);
Relaxation relaxation_of(const PoleSum& stiffness);

/// The dual of a pole sum P: 1/(s P(s)) as a pole sum, its positive rates as offsets from those
/// of P. `at_rest` is the weight of its pole at 0, 0 without one.
struct DualPoles {
  double direct = 0;
  double at_rest = 0;
  std::vector<OffsetRate> rates;
  std::vector<double> weights;
};

/// Time grows with the square of the rates: a minute for so many.
constexpr std::size_t most_rates = 20'000;

/// Throws InputError beyond `most_rates`, and unless each rate has its weight.
DualPoles dual(const PoleSum& sum);

}  // namespace vcrit
