// One of GSL's adaptive integrators for a system of equations, with the step that it just took at
// hand: what happens inside it is found by taking a shorter one from the same beginning.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <vector>

#include "simulation/system/effort.hpp"

namespace vcrit::simulation::methods {

class Ode {
 public:
  virtual ~Ode() = default;
  virtual void rates(double t, const double* y, double* dydt) = 0;
  /// d rates/dy by rows, and d rates/dt.
  virtual void jacobian(double t, const double* y, double* by_y, double* by_t) = 0;
};

/// Shared by the integrators of one search for a steady state.
struct StepBudget {
  long left = 0;
  long most = 0;
  Effort effort{effort_of_method, nullptr, beyond_effort_of_method};
  void take(double size);  ///< throws ModelError when none is left
};

class GslIntegrator {
 public:
  /// scales: sizes of the entries below which their error counts absolutely.
  GslIntegrator(Ode& ode, const gsl_odeiv2_step_type* type, const std::vector<double>& scales,
                double tolerance, StepBudget& budget);
  GslIntegrator(const GslIntegrator&) = delete;
  GslIntegrator& operator=(const GslIntegrator&) = delete;

  void begin(double t, std::vector<double> y);
  /// State or equations have changed: nothing learnt before applies.
  void restart();
  /// One step, not beyond `limit`. Throws ModelError where it cannot.
  void step(double limit);

  /// Replaces the step by a shorter one, to a time inside it and after all those kept.
  void shorten(double t);
  /// From here to the step's end: a method of several steps need not begin again at its start.
  void keep();
  /// The step as it was.
  void lengthen();

  double time() const { return t_; }
  std::vector<double>& state() { return y_; }
  const double* rates() const { return driver_->e->dydt_out; }
  double step_begin() const { return t0_; }
  /// Of the full step, not of a shortened one.
  const double* rates_at_begin() const { return driver_->e->dydt_in; }
  const double* state_at_begin() const { return driver_->e->y0; }

 private:
  struct Free {
    void operator()(gsl_odeiv2_driver* driver) const { gsl_odeiv2_driver_free(driver); }
  };
  static int rates_of(double t, const double y[], double dydt[], void* self);
  static int jacobian_of(double t, const double y[], double* by_y, double by_t[], void* self);
  void evolve(double limit);
  void count();
  void check(int status) const;

  Ode& ode_;
  std::size_t work_ = 0;  ///< since it was counted last: GSL's C lets no error through
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, Free> driver_;
  StepBudget& budget_;
  bool multistep_;
  double first_step_, h_;
  double t_ = 0, t0_ = 0, t1_ = 0, kept_ = 0;
  bool shortened_ = false;
  std::vector<double> y_, y1_, kept_y_, error_;
};

}  // namespace vcrit::simulation::methods
