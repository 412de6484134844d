#include "simulation/methods/reduced.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/methods/equations.hpp"

namespace vcrit::simulation::methods {

namespace {

/// Stick that begins at tau1.
struct Stick {
  double delta, ratio, begin;
};

// cos(a + x) - cos a and sin(a + x) - sin a without cancellation.
double cos_change(double a, double x) { return -2 * std::sin(a + x / 2) * std::sin(x / 2); }
double sin_change(double a, double x) { return 2 * std::cos(a + x / 2) * std::sin(x / 2); }

// f of the header after a time x of stick: friction bound less force, over D.
double gap(double x, void* data) {
  const auto& [delta, ratio, begin] = *static_cast<const Stick*>(data);
  return cos_change(begin, x) - delta * sin_change(begin, x) - ratio * x;
}

// f rises from 0 while sin(tau + atan delta) < -v/sqrt(1 + delta^2), then falls, and rises again
// only after tau1 + 2 pi at the latest, where it is -2 pi v: one zero between its maximum and
// there.
double duration(Stick stick) {
  gsl_function function{gap, &stick};
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  const double size = std::hypot(1, stick.delta);
  const double highest =
      two_pi - std::asin(stick.ratio / size) - std::atan(stick.delta) - stick.begin;
  if (!(gap(highest, &stick) > 0)) return 0;  // v = 1 but for rounding
  int status = gsl_root_fsolver_set(solver.get(), &function, highest, two_pi);
  for (int i = 0; i < 200 && status == GSL_SUCCESS; ++i) {
    status = gsl_root_fsolver_iterate(solver.get());
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                               gsl_root_fsolver_x_upper(solver.get()), 0,
                               4 * GSL_DBL_EPSILON) == GSL_SUCCESS)
      break;
  }
  ensure(status == GSL_SUCCESS, "the end of stick is bracketed");
  return gsl_root_fsolver_root(solver.get());
}

void require_kelvin_contact(const System& system) {
  const auto refuse = [](const char* what) {
    throw ModelError(fmt::format(
        "the reduced model (47)-(52) is of a Kelvin contact under a rigid drive without "
        "mass; this scene has {}",
        what));
  };
  if (system.opening) refuse("a contact that opens");
  if (system.masses) refuse("a drive with masses");
  if (system.drive)
    refuse(system.mass ? "a drive that is not rigid, and a mass" : "a drive that is not rigid");
  if (!system.contact.branches.empty()) refuse("a tangential contact with Maxwell branches");
  if (!(system.contact.equilibrium > 0)) refuse("a tangential contact without a spring");
}

}  // namespace

SteadyState reduced_model(const System& system, double velocity) {
  require_kelvin_contact(system);
  // Stiffness is in units of |K_t| = k sqrt(1 + delta^2), so the velocity is v D sqrt(1 + delta^2).
  const Equations equations(system, velocity);
  const double delta = system.omega * system.contact.damper / system.contact.equilibrium;
  const double ratio = equations.velocity / equations.amplitude;
  if (ratio >= 1) return {1, 0, Regime::sliding, 1, {}, {}};

  const Stick stick{delta, ratio, pi + std::asin(ratio)};
  const double d = equations.amplitude / std::hypot(1, delta), x = duration(stick);
  const double end = stick.begin + x, left = two_pi - x;
  const double lost = sin_change(stick.begin, x) + delta * cos_change(stick.begin, x) -
                      x * (ratio * x / 2 + std::cos(stick.begin) + delta * ratio);
  SteadyState state;
  state.friction_ratio = 1 - d * lost / two_pi;
  // C exp(-(tau - tau2)/delta) at the end of slip, summed over the periods before.
  const double transient = d * delta * (ratio + std::sin(end));
  const double kept = delta > 0 ? std::abs(transient) / std::expm1(left / delta) : 0;
  state.friction_ratio_error = kept + 4 * GSL_DBL_EPSILON;
  state.regime = Regime::stick_slip;
  state.periods = 1;
  // The model's F_n has its maximum at tau = -atan delta.
  const double shift = std::atan(delta);
  state.events = {{equations.phase_at(stick.begin + shift), Motion::stick},
                  {equations.phase_at(end + shift), Motion::slip}};
  if (state.events[1].phase < state.events[0].phase) std::swap(state.events[0], state.events[1]);
  return state;
}

}  // namespace vcrit::simulation::methods
