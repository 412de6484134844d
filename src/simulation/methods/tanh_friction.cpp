#include "simulation/methods/tanh_friction.hpp"

#include <algorithm>

#include "base/constants.hpp"
#include "simulation/methods/equations.hpp"
#include "simulation/methods/gsl_integrator.hpp"

namespace vcrit::simulation::methods {

namespace {

// Longer steps would see too little of a cosine, and of a short stick nothing.
constexpr double longest_tanh_step = two_pi / 16;

// Slower than this many w_reg, where tanh is 0.995, is called stick.
constexpr double stuck = 3;

// Rates beyond which an explicit method would be held back by stability.
constexpr double stiff = 300;

/// Root of bound tanh x + damping x = load for load >= 0. The left side is concave: Newton's steps
/// from below stay below.
double slip_over_regularisation(double load, double bound, double damping) {
  double x = std::max((load - bound) / damping, load / (bound + damping));
  for (int i = 0; i < 50; ++i) {
    const double tanh = std::tanh(x), slope = bound * (1 - tanh * tanh) + damping;
    const double step = (load - bound * tanh - damping * x) / slope;
    x += step;
    if (!(step > 1e-15 * x)) break;
  }
  return x;
}

class TanhOde final : public Ode {
 public:
  TanhOde(const Equations& equations, double regularisation)
      : equations_(equations),
        regularisation_(regularisation * equations.velocity),
        damper_(equations.contact.damper > 0 ? equations.contact.damper : regularisation) {}

  double contact_velocity(double t, const double* y) const {
    const double load = load_of(y, equations_.top_velocity(y, equations_.velocity));
    return std::copysign(regularisation_, load) *
           slip_over_regularisation(std::abs(load), equations_.bound(t), damper_ * regularisation_);
  }

  void rates(double t, const double* y, double* dydt) override {
    const double w = contact_velocity(t, y), bound = equations_.bound(t);
    const double force = bound * std::tanh(w / regularisation_);
    equations_.rates(y, equations_.velocity, w, force, dydt);
    dydt[equations_.size()] = bound - force;
  }

  void jacobian(double t, const double* y, double* by_y, double* by_t) override {
    const std::size_t n = equations_.size() + 1;
    const double tanh = std::tanh(contact_velocity(t, y) / regularisation_);
    const double stiffness = equations_.bound(t) * (1 - tanh * tanh) / regularisation_;
    unit_.assign(n, 0.0);
    column_.assign(n, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      unit_[j] = 1;
      const double w =
          load_of(unit_.data(), equations_.top_velocity(unit_.data(), 0)) / (stiffness + damper_);
      equations_.rates(unit_.data(), 0, w, stiffness * w, column_.data());
      column_[n - 1] = -stiffness * w;
      unit_[j] = 0;
      for (std::size_t i = 0; i < n; ++i) by_y[i * n + j] = column_[i];
    }
    const double rate = equations_.bound_rate(t) * tanh, w = -rate / (stiffness + damper_);
    equations_.rates(unit_.data(), 0, w, rate + stiffness * w, by_t);
    by_t[n - 1] = equations_.bound_rate(t) - rate - stiffness * w;
  }

  Motion motion(double w) const {
    if (std::abs(w) < threshold()) return Motion::stick;
    return w > 0 ? Motion::slip : Motion::backslip;
  }
  double threshold() const { return stuck * regularisation_; }

  /// Fastest rate in the system, roughly.
  double fastest_rate() const {
    double fastest = equations_.contact.glassy / damper_;
    for (const Branch& branch : equations_.contact.branches)
      fastest = std::max(fastest, branch.rate);
    if (equations_.masses)
      return std::max(fastest, equations_.masses->fastest_rate(damper_, equations_.contact.glassy));
    if (!equations_.body) return fastest;
    const auto& [mass, drive] = *equations_.body;
    for (const Branch& branch : drive.branches) fastest = std::max(fastest, branch.rate);
    return std::max({fastest, (damper_ + drive.damper) / mass,
                     std::sqrt((equations_.contact.glassy + drive.glassy) / mass)});
  }

 private:
  // A system without states (a damper alone) has no entries of y but the deficit.
  double load_of(const double* y, double top) const {
    return damper_ * top + equations_.contact.sum(equations_.contact_forces(y));
  }

  const Equations& equations_;
  double regularisation_, damper_;
  std::vector<double> unit_, column_;
};

class TanhMap final : public PeriodMap {
 public:
  TanhMap(const System& system, double velocity, const MethodOptions& options)
      : equations_(system, velocity),
        ode_(equations_, options.regularisation),
        coarser_ode_(equations_, 3 * options.regularisation),
        budget_{options.most_steps, options.most_steps},
        scales_(scales()),
        noise_(std::max(
            stepper() == gsl_odeiv2_step_msbdf ? 30 * options.tolerance : options.tolerance,
            1e-14)),
        asked_(ode_, stepper(), scales_, options.tolerance, budget_),
        coarser_(coarser_ode_, stepper(), scales_, 10 * options.tolerance, budget_) {}

  MapState start(Start start) const override {
    const std::vector<double> y = equations_.start(start);
    return {Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())),
            start == Start::rest ? Motion::stick : Motion::slip};
  }

  Period run(const MapState& state, PeriodAccuracy accuracy) override {
    const bool asked = accuracy == PeriodAccuracy::asked;
    return run(state, asked ? ode_ : coarser_ode_, asked ? asked_ : coarser_);
  }

  std::vector<Eigen::Index> variables(const MapState& state) const override {
    std::vector<Eigen::Index> list(static_cast<std::size_t>(state.y.size()));
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = static_cast<Eigen::Index>(i);
    return list;
  }
  double scale(Eigen::Index variable) const override {
    return scales_[static_cast<std::size_t>(variable)];
  }
  double noise() const override { return noise_; }
  double target() const override { return 10 * noise_; }
  double slowest_rate() const override { return equations_.slowest_rate(); }

 private:
  const gsl_odeiv2_step_type* stepper() const {
    return ode_.fastest_rate() > stiff ? gsl_odeiv2_step_msbdf : gsl_odeiv2_step_rk8pd;
  }
  std::vector<double> scales() const {
    std::vector<double> list = equations_.scales();
    list.push_back(1);  // the deficit
    return list;
  }
  // Events to first order, between the ends of a step.
  Period run(const MapState& state, const TanhOde& ode, GslIntegrator& integrator) const {
    std::vector<double> y(state.y.data(), state.y.data() + state.y.size());
    y.push_back(0);
    integrator.begin(0, std::move(y));
    Period period;
    double w = ode.contact_velocity(0, integrator.state().data());
    Motion motion = ode.motion(w);
    while (integrator.time() < two_pi) {
      const double before = integrator.time();
      integrator.step(std::min(two_pi, before + longest_tanh_step));
      const double after = ode.contact_velocity(integrator.time(), integrator.state().data());
      if (ode.motion(after) != motion) {
        motion = ode.motion(after);
        const double low = std::abs(w), high = std::abs(after);
        const double share = std::clamp((ode.threshold() - low) / (high - low), 0.0, 1.0);
        period.events.push_back(
            {equations_.phase_at(before + share * (integrator.time() - before)), motion});
      }
      w = after;
    }
    const auto& end = integrator.state();
    period.deficit = end.back() / two_pi;
    period.end = {Eigen::Map<const Eigen::VectorXd>(end.data(), state.y.size()), motion};
    return period;
  }

  Equations equations_;
  TanhOde ode_, coarser_ode_;
  StepBudget budget_;
  std::vector<double> scales_;
  double noise_;
  GslIntegrator asked_, coarser_;
};

}  // namespace

std::unique_ptr<PeriodMap> tanh_map(const System& system, double velocity,
                                    const MethodOptions& options) {
  return std::make_unique<TanhMap>(system, velocity, options);
}

}  // namespace vcrit::simulation::methods
