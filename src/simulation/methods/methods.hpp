// Methods for the steady stick-slip motion that people use, beside the exact one and sharing no
// code with it but the system. docs/methods.md says what each does and where it goes wrong.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/numbers.hpp"
#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

enum class Method {
  moreau,   ///< Moreau-Jean time stepping: fixed step, implicit, Coulomb's law exact in each step
  rkf45,    ///< GSL's adaptive Runge-Kutta-Fehlberg 4(5), switching at located events
  rk8pd,    ///< the same with Prince-Dormand 8(9)
  msbdf,    ///< the same with backward differentiation of order 1 to 5: stiff systems
  tanh,     ///< friction mu0 F_n tanh(w/w_reg), adaptive
  reduced,  ///< the paper's (47)-(52): Kelvin contact under a rigid drive, transient of slip
            ///< dropped
};

std::span<const Method> all_methods();
// The overload below hides none of the others.
using vcrit::to_text;
const char* to_text(Method method);  ///< the enumerator's name
std::optional<Method> method_named(std::string_view name);

/// Each method reads those that concern it.
struct MethodOptions {
  Start start = Start::sliding;
  /// rkf45, rk8pd, msbdf, tanh: error a step, relative and in units of mu0 <F_n>;
  /// from 1e-15 to 1e-3; tanh: to a tenth of the regularisation.
  double tolerance = 1e-10;
  /// moreau: 4 to 1e7.
  int steps_per_period = 2000;
  /// moreau: 1/2 (second order) to 1 (first order).
  double theta = 0.5;
  /// tanh: w_reg in units of the drive velocity; 1e-12 to 1.
  double regularisation = 1e-3;
  /// Newton on the period map by differences, all but reduced; else periods until they repeat.
  bool newton = true;
  /// Give up after as many periods, or steps of an integrator.
  int most_periods = 20'000;
  long most_steps = 5'000'000;
};

/// velocity: mean velocity of the drive, m/s, > 0. The error estimate covers what the method
/// idealises too (w_reg, the dropped transient), to leading order. Throws ModelError where the
/// method cannot treat the system, does not settle or goes wrong, and says how; InputError for
/// options out of range.
SteadyState steady_state(Method method, const System& system, double velocity,
                         const MethodOptions& options = {});

}  // namespace vcrit::simulation
