#include "simulation/methods/gsl_integrator.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit::simulation::methods {

namespace {

int rates_of(double t, const double y[], double dydt[], void* ode) {
  static_cast<Ode*>(ode)->rates(t, y, dydt);
  return GSL_SUCCESS;
}

int jacobian_of(double t, const double y[], double* by_y, double by_t[], void* ode) {
  static_cast<Ode*>(ode)->jacobian(t, y, by_y, by_t);
  return GSL_SUCCESS;
}

}  // namespace

void StepBudget::take(double size) {
  if (left-- <= 0)
    throw ModelError(
        fmt::format("has not settled after {} steps, the last of {:.1g}/omega", most, size));
}

GslIntegrator::GslIntegrator(Ode& ode, const gsl_odeiv2_step_type* type,
                             const std::vector<double>& scales, double tolerance,
                             StepBudget& budget)
    : system_{rates_of, jacobian_of, scales.size(), &ode},
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
  if (status != GSL_SUCCESS || !finite)
    throw ModelError(fmt::format("{} cannot go on: {}, at a step of {:.1g}/omega",
                                 gsl_odeiv2_step_name(driver_->s),
                                 finite ? gsl_strerror(status) : "the state is not finite", h_));
}

void GslIntegrator::evolve(double limit) {
  hear_interruption();
  budget_.take(h_);
  check(gsl_odeiv2_evolve_apply(driver_->e, driver_->c, driver_->s, &system_, &t_, limit, &h_,
                                y_.data()));
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
