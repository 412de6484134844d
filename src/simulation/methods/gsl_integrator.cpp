#include "simulation/methods/gsl_integrator.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit::simulation::methods {

namespace {

// What a call takes whatever the number of states, in units of effort.
constexpr std::size_t call_work = 12;

}  // namespace

int GslIntegrator::rates_of(double t, const double y[], double dydt[], void* self) {
  auto& integrator = *static_cast<GslIntegrator*>(self);
  integrator.work_ += call_work + integrator.system_.dimension;
  integrator.ode_.rates(t, y, dydt);
  return GSL_SUCCESS;
}

// By columns, each as much as all rates. GSL then takes the matrix apart, number by number: n^3/3
// products of some 2 ns.
int GslIntegrator::jacobian_of(double t, const double y[], double* by_y, double by_t[],
                               void* self) {
  auto& integrator = *static_cast<GslIntegrator*>(self);
  const std::size_t n = integrator.system_.dimension;
  integrator.work_ += call_work + n * n + n * n * n / 20;
  integrator.ode_.jacobian(t, y, by_y, by_t);
  return GSL_SUCCESS;
}

void StepBudget::take(double size) {
  if (left-- <= 0)
    throw ModelError(
        fmt::format("has not settled after {} steps, the last of {:.1g}/omega", most, size));
}

GslIntegrator::GslIntegrator(Ode& ode, const gsl_odeiv2_step_type* type,
                             const std::vector<double>& scales, double tolerance,
                             StepBudget& budget)
    : ode_(ode),
      system_{rates_of, jacobian_of, scales.size(), this},
      driver_(gsl_odeiv2_driver_alloc_scaled_new(&system_, type, 1e-3, tolerance, tolerance, 1, 0,
                                                 scales.data())),
      budget_(budget),
      multistep_(type == gsl_odeiv2_step_msbdf),
      first_step_(multistep_ ? std::sqrt(tolerance) : 0.1),
      h_(first_step_),
      error_(scales.size()) {
  ensure(driver_ != nullptr, "GSL allocates its integrator");
}

void GslIntegrator::begin(double t, std::vector<double> y) {
  t_ = t;
  y_ = std::move(y);
  restart();
}

void GslIntegrator::restart() {
  gsl_odeiv2_evolve_reset(driver_->e);
  gsl_odeiv2_step_reset(driver_->s);
  if (multistep_) h_ = first_step_;
}

void GslIntegrator::check(int status) const {
  const bool finite = std::all_of(y_.begin(), y_.end(), [](double x) { return std::isfinite(x); });
  if (status == GSL_SUCCESS && finite) return;
  // GSL's word for a step that no longer moves the time is "failure".
  const char* reason = !finite                 ? "the state is not finite"
                       : status == GSL_FAILURE ? "the steps that it needs are too short for doubles"
                                               : gsl_strerror(status);
  throw ModelError(fmt::format("cannot go on: {}, at a step of {:.1g}/omega", reason, h_));
}

void GslIntegrator::count() { budget_.effort.spend(std::exchange(work_, 0)); }

void GslIntegrator::evolve(double limit) {
  hear_interruption();
  budget_.take(h_);
  check(gsl_odeiv2_evolve_apply(driver_->e, driver_->c, driver_->s, &system_, &t_, limit, &h_,
                                y_.data()));
  count();
}

void GslIntegrator::step(double limit) {
  t0_ = t_;
  shortened_ = false;
  evolve(limit);
}

void GslIntegrator::shorten(double t) {
  if (!shortened_) {
    shortened_ = true;
    t1_ = t_;
    y1_ = y_;
    kept_ = t0_;
    kept_y_.assign(driver_->e->y0, driver_->e->y0 + y_.size());
  }
  t_ = kept_;
  std::copy(kept_y_.begin(), kept_y_.end(), y_.begin());
  if (!multistep_) {
    budget_.take(t - t_);
    check(gsl_odeiv2_step_apply(driver_->s, t_, t - t_, y_.data(), error_.data(),
                                driver_->e->dydt_in, driver_->e->dydt_out, &system_));
    t_ = t;
    count();
    return;
  }
  restart();
  while (t_ < t) evolve(t);
}

void GslIntegrator::keep() {
  if (!multistep_) return;
  kept_ = t_;
  kept_y_ = y_;
}

void GslIntegrator::lengthen() {
  t_ = t1_;
  y_ = y1_;
  if (multistep_) restart();
}

}  // namespace vcrit::simulation::methods
