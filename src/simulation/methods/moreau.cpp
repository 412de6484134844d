#include "simulation/methods/moreau.hpp"

#include <algorithm>
#include <optional>

#include "base/constants.hpp"
#include "linear/elimination.hpp"
#include "simulation/methods/equations.hpp"
#include "simulation/methods/normal_steps.hpp"

namespace vcrit::simulation::methods {

namespace {

// What a step takes without branches, in units of effort.
constexpr std::size_t moreau_step_work = 8;

/// An affine function of the network's velocity e' over the step: offset(f_0) + slope e'.
struct Affine {
  std::vector<double> kept;  ///< of each branch's force
  double slope = 0;

  double offset(const double* forces) const {
    double sum = 0;
    for (std::size_t j = 0; j < kept.size(); ++j) sum += kept[j] * forces[j];
    return sum;
  }
};

/// A network over one step: f_1 = kept f_0 + gain e' for each branch.
class SteppedChain {
 public:
  SteppedChain(const Chain& chain, double h, double theta) : damper_(chain.damper) {
    for (const Branch& branch : chain.branches) {
      const double share = 1 / (1 + theta * branch.rate * h);
      branches_.push_back({1 - branch.rate * h * share, h * branch.stiffness * share});
    }
  }

  /// c e' + sum of (1 - theta) f_0 + theta f_1.
  Affine force(double theta) const {
    Affine result{{}, damper_};
    for (const Coefficients& branch : branches_) {
      result.kept.push_back(1 - theta + theta * branch.kept);
      result.slope += theta * branch.gain;
    }
    return result;
  }
  void step(double* forces, double velocity) const {
    for (std::size_t j = 0; j < branches_.size(); ++j)
      forces[j] = branches_[j].kept * forces[j] + branches_[j].gain * velocity;
  }

 private:
  struct Coefficients {
    double kept, gain;
  };
  double damper_;
  std::vector<Coefficients> branches_;
};

/// Masses over one step: x_theta = (1 - theta h A)^-1 (x_0 + theta h F push), so that the velocity
/// of the body's end is its own without F less give F, in the frame of the far end.
struct SteppedMasses {
  SteppedMasses(const DrivenMasses& masses, double step, double implicit)
      : theta(implicit), kept(masses.matrix().rows() + 1, masses.matrix().cols()) {
    const Eigen::Index n = kept.cols();
    kept.topRows(n) =
        linear::Lu<double>(Eigen::MatrixXd::Identity(n, n) - theta * step * masses.matrix())
            .inverse();
    pushed = theta * step * kept.topRows(n) * masses.push();
    give = -masses.end_velocity(pushed.data());
    for (Eigen::Index j = 0; j < n; ++j) kept(n, j) = masses.end_velocity(kept.col(j).data());
  }

  /// Without F. The lazy product adds up each row in one register, column by column.
  double velocity(const double* x) {
    free.noalias() = kept.lazyProduct(Eigen::Map<const Eigen::VectorXd>(x, kept.cols()));
    return free(kept.cols());
  }
  /// x_1 = x_0 + (x_theta - x_0)/theta, after the velocity.
  void take(double* x, double force) const {
    for (Eigen::Index i = 0; i < kept.cols(); ++i)
      x[i] += (free(i) + force * pushed(i) - x[i]) / theta;
  }

  double theta;
  Eigen::MatrixXd kept;  ///< of x_0 in x_theta and, below, in the velocity
  Eigen::VectorXd pushed, free;
  double give = 0;
};

class Stepper {
 public:
  /// bounds: at each step, or none for those of a contact that stays closed.
  Stepper(const Equations& equations, int steps, double theta, std::vector<double> bounds)
      : equations_(equations),
        h_(two_pi / steps),
        theta_(theta),
        contact_(equations.contact, h_, theta),
        drive_(equations.body ? equations.body->drive : Chain{}, h_, theta),
        on_body_(contact_.force(theta)),
        from_drive_(drive_.force(theta)),
        bounds_(std::move(bounds)) {
    const double rate = equations.contact.glassy / equations.contact.damper;
    const double law = std::max(theta, 1 - 1 / (rate * h_));
    on_point_ = contact_.force(law);
    if (equations.body) inertia_ = equations.body->mass / (theta * h_);
    if (equations.masses) masses_.emplace(*equations.masses, h_, theta);
    if (!bounds_.empty()) return;
    for (int i = 0; i < steps; ++i) bounds_.push_back(equations.bound((i + law) * h_));
  }

  std::size_t steps() const { return bounds_.size(); }

  Period run(const MapState& state) {
    if (masses_) return run_on<Above::masses>(state);
    return equations_.body ? run_on<Above::body>(state) : run_on<Above::drive>(state);
  }

 private:
  /// What the contact hangs on. Known before the steps, of which each is short: asking in each
  /// takes a fifth of it.
  enum class Above { drive, body, masses };

  struct Outcome {
    double force, velocity;  ///< of the contact point
    Motion motion;
  };

  template <Above above>
  Period run_on(const MapState& state) {
    Period period{state, 0, {}, infinity};
    double* const y = period.end.y.data();
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      const auto [force, velocity, motion] = step<above>(y, bounds_[i]);
      period.deficit += bounds_[i] - force;
      period.slowest = std::min(period.slowest, velocity);
      if (motion == period.end.motion) continue;
      period.end.motion = motion;
      period.events.push_back({equations_.phase_at(static_cast<double>(i) * h_), motion});
    }
    period.deficit /= static_cast<double>(bounds_.size());
    return period;
  }

  template <Above above>
  Outcome step(double* y, double bound) {
    double* const forces = y + equations_.contact_begin();
    constexpr bool moves = above != Above::drive;
    const double law = on_point_.offset(forces), load = on_body_.offset(forces);
    const double resistance = resistance_of<above>();
    const double push = moves ? unloaded<above>(y, resistance) - load : 0;
    double top = moves ? push / (resistance + on_body_.slope) : equations_.velocity;
    double deformation = top, force = law + on_point_.slope * top;
    Motion motion = Motion::stick;
    if (std::abs(force) > bound || bound == 0) {
      motion = bound == 0 ? Motion::separated : (force > 0 ? Motion::slip : Motion::backslip);
      force = std::copysign(bound, force);
      deformation = (force - law) / on_point_.slope;
      if (moves) top = (push - on_body_.slope * deformation) / resistance;
    }
    if constexpr (above == Above::masses) masses_->take(y, load + on_body_.slope * deformation);
    contact_.step(forces, deformation);
    if constexpr (above == Above::body) {
      drive_.step(y + 1, equations_.velocity - top);
      y[0] += (top - y[0]) / theta_;
    }
    return {force, top - deformation, motion};
  }

  template <Above above>
  double resistance_of() const {
    if constexpr (above == Above::masses) return 1 / masses_->give;
    return inertia_ + from_drive_.slope;
  }

  /// The force that would hold the body's end still, without the contact.
  template <Above above>
  double unloaded(const double* y, double resistance) {
    if constexpr (above == Above::masses)
      return resistance * (equations_.velocity + masses_->velocity(y));
    return inertia_ * y[0] + from_drive_.offset(y + 1) + from_drive_.slope * equations_.velocity;
  }

  const Equations& equations_;
  double h_, theta_;
  SteppedChain contact_, drive_;
  Affine on_body_, from_drive_, on_point_;
  std::optional<SteppedMasses> masses_;
  double inertia_ = 0;
  std::vector<double> bounds_;
};

// A contact that opens, as one that stays closed under the mean of its steps' own normal force.
struct Normal {
  Normal(const System& given, const MethodOptions& options) : system(given), theta(options.theta) {
    if (!given.opening) return;
    theta = 1;  // the bound is known at the end of a step
    const auto steps = [&](int count) {
      return normal_force_steps(*given.opening, given.omega, count, effort);
    };
    asked = steps(options.steps_per_period);
    coarser = steps(options.steps_per_period / 3);
    double sum = 0;
    for (const double force : asked) sum += force;
    system.opening.reset();
    system.mean_normal_force = sum / options.steps_per_period;
    for (std::vector<double>* forces : {&asked, &coarser})
      for (double& force : *forces) force /= system.mean_normal_force;
  }

  System system;
  double theta;
  Effort effort{effort_of_method, nullptr, beyond_effort_of_method};
  std::vector<double> asked, coarser;  ///< in units of the mean
};

class MoreauMap final : public PeriodMap {
 public:
  MoreauMap(const Normal& normal, double velocity, const MethodOptions& options)
      : equations_(normal.system, velocity),
        scales_(equations_.scales()),
        target_(1e-3 / options.steps_per_period),
        effort_(normal.effort),
        asked_(equations_, options.steps_per_period, normal.theta, normal.asked),
        coarser_(equations_, options.steps_per_period / 3, normal.theta, normal.coarser) {
    for (std::size_t i = 1; i < normal.asked.size(); ++i)
      resolution_ += std::abs(normal.asked[i] - normal.asked[i - 1]) / options.steps_per_period;
  }

  MapState start(Start start) const override {
    const std::vector<double> y = equations_.start(start);
    return {Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())),
            start == Start::rest ? Motion::stick : Motion::slip};
  }
  Period run(const MapState& state, PeriodAccuracy accuracy) override {
    Stepper& stepper = accuracy == PeriodAccuracy::asked ? asked_ : coarser_;
    effort_.spend(stepper.steps() * (moreau_step_work + equations_.size()));
    return stepper.run(state);
  }
  std::vector<Eigen::Index> variables(const MapState& state) const override {
    std::vector<Eigen::Index> list(static_cast<std::size_t>(state.y.size()));
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = static_cast<Eigen::Index>(i);
    return list;
  }
  double scale(Eigen::Index variable) const override {
    return scales_[static_cast<std::size_t>(variable)];
  }
  double noise() const override { return 1e-13; }
  double resolution() const override { return resolution_; }
  double target() const override { return target_; }
  double slowest_rate() const override { return equations_.slowest_rate(); }

 private:
  Equations equations_;
  std::vector<double> scales_;
  double target_;
  Effort effort_;
  Stepper asked_, coarser_;
  // Where in a step the contact opens or closes, steps of another length do not tell: the mean of
  // what a step changes the bound by.
  double resolution_ = 0;
};

}  // namespace

std::unique_ptr<PeriodMap> moreau_map(const System& system, double velocity,
                                      const MethodOptions& options) {
  return std::make_unique<MoreauMap>(Normal(system, options), velocity, options);
}

}  // namespace vcrit::simulation::methods
