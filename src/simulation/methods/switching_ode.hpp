// The equations of motion in slip, stick or backslip, each with the function whose zero ends it:
// s w in slip of sign s, b - |F| in stick. Behind the state stands the integral of b - F, whose
// mean over a period is 1 - mu_macro/mu0; in slip it does not change.
#pragma once

#include "simulation/methods/equations.hpp"
#include "simulation/methods/gsl_integrator.hpp"

namespace vcrit::simulation::methods {

/// How an event function leaves 0 where its motion begins: value tau^order to leading order.
/// value <= 0: it does not, the motion before goes on.
struct Rise {
  int order = 0;
  double value = 0;
};

class SwitchingOde final : public Ode {
 public:
  explicit SwitchingOde(const Equations& equations) : equations_(equations) {}

  Motion motion = Motion::slip;

  void rates(double t, const double* y, double* dydt) override;
  void jacobian(double t, const double* y, double* by_y, double* by_t) override;

  double event(double t, const double* y) const;
  double event_rate(double t, const double* y, const double* dydt) const;

  /// Begins with a state from elsewhere, in the present motion if it allows that.
  Rise adopt(double t, std::vector<double>& y);
  /// Changes the motion where the event function is 0.
  Rise change(double t, std::vector<double>& y);
  /// Without a direct damper slip ties the state to F = s b: puts it there. Stick must begin there
  /// too, or it chatters.
  void tie(double t, std::vector<double>& y) const;
  bool tied() const { return motion != Motion::stick && !damped(); }

 private:
  bool damped() const { return equations_.contact.damper > 0; }
  double sign() const { return motion == Motion::backslip ? -1 : 1; }
  /// b'(t) where slip_velocity() needs it.
  double slope_of_bound(double t) const { return tied() ? equations_.bound_rate(t) : 0; }
  double slip_velocity(const double* y, double top, double bound, double bound_rate) const;
  void rates(const double* y, double velocity, double bound, double bound_rate, double* dydt) const;
  Rise begin_stick(double t, std::vector<double>& y);
  Rise begin_slip(double t, std::vector<double>& y);
  double rate_of_event(double t, const std::vector<double>& y);

  const Equations& equations_;
  std::vector<double> scratch_;
};

}  // namespace vcrit::simulation::methods
