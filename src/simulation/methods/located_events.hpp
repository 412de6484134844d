// Finds the event inside a step of an integrator: the first zero of the event function, by Newton's
// method on shorter and shorter steps, inside a bracket. The events that step ends do not show:
//  * where a motion begins, its event function leaves 0 like value tau^order; it is divided by
//    tau^order, so that a motion shorter than the step is bracketed all the same;
//  * a minimum below 0 between two ends above: the ends' slopes say where to look (grazing).
#pragma once

#include "simulation/methods/switching_ode.hpp"

namespace vcrit::simulation::methods {

class EventFinder {
 public:
  /// zero: size of an event function that counts as 0.
  EventFinder(const SwitchingOde& ode, GslIntegrator& integrator, double zero)
      : ode_(ode), integrator_(integrator), zero_(zero) {}

  /// Whether the motion ended within the step just taken; then the integrator stands at its end.
  bool find(const Rise& rise);

 private:
  struct Value {
    double value, slope;
  };
  Value here() const;
  Value at(double tau);
  bool dips(const Value& begin, const Value& end);
  void close_in(double low, double high, const Value& end, const Rise& rise);

  const SwitchingOde& ode_;
  GslIntegrator& integrator_;
  double zero_;
};

}  // namespace vcrit::simulation::methods
