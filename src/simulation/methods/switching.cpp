#include "simulation/methods/switching.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/methods/located_events.hpp"

namespace vcrit::simulation::methods {

namespace {

// Longer steps would see too little of a cosine.
constexpr double longest_switching_step = two_pi / 8;

// More in one period are chatter about an event that rounding moves to and fro.
constexpr int most_changes = 200;

const gsl_odeiv2_step_type* stepper(Method method) {
  switch (method) {
    case Method::rkf45:
      return gsl_odeiv2_step_rkf45;
    case Method::rk8pd:
      return gsl_odeiv2_step_rk8pd;
    case Method::msbdf:
      return gsl_odeiv2_step_msbdf;
    case Method::moreau:
    case Method::tanh:
    case Method::reduced:
      break;
  }
  throw Bug("not a method that switches");
}

// The errors of msbdf are some 30 times its tolerance, and hardly follow it over one decade.
double accuracy(Method method) { return method == Method::msbdf ? 30 : 1; }
double coarsening(Method method) { return method == Method::msbdf ? 30 : 10; }

class SwitchingMap final : public PeriodMap {
 public:
  SwitchingMap(Method method, const System& system, double velocity, const MethodOptions& options)
      : equations_(system, velocity),
        ode_(equations_),
        budget_{options.most_steps, options.most_steps},
        tolerance_(options.tolerance),
        noise_(std::max(accuracy(method) * tolerance_, 1e-14)),
        scales_(scales()),
        asked_(ode_, stepper(method), scales_, tolerance_, budget_),
        coarser_(ode_, stepper(method), scales_, coarsening(method) * tolerance_, budget_) {}

  MapState start(Start start) const override {
    const std::vector<double> y = equations_.start(start);
    return {Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())),
            start == Start::rest ? Motion::stick : Motion::slip};
  }

  Period run(const MapState& state, PeriodAccuracy accuracy) override {
    return run(state, section_ + two_pi, accuracy == PeriodAccuracy::asked ? asked_ : coarser_);
  }

  // The middle of the longest motion: as far from events as can be.
  MapState to_smooth_section(const MapState& state) override {
    const Period period = run(state, section_ + two_pi, asked_);
    if (stretches_.size() < 2) return period.end;
    stretches_.front().begin = stretches_.back().begin - two_pi;
    stretches_.pop_back();
    const auto longest = std::max_element(
        stretches_.begin(), stretches_.end(),
        [](const Stretch& a, const Stretch& b) { return a.end - a.begin < b.end - b.begin; });
    double middle = (longest->begin + longest->end) / 2;
    if (middle <= section_) middle += two_pi;
    const Period part = run(period.end, middle, asked_);
    section_ = middle < two_pi ? middle : middle - two_pi;
    return part.end;
  }

  std::vector<Eigen::Index> variables(const MapState& state) const override {
    std::vector<Eigen::Index> list;
    const bool tied = state.motion != Motion::stick && equations_.contact.damper == 0;
    const std::size_t main = equations_.contact_begin() + equations_.contact.main_branch();
    for (std::size_t i = 0; i < equations_.size(); ++i)
      if (!tied || i != main) list.push_back(static_cast<Eigen::Index>(i));
    return list;
  }

  double scale(Eigen::Index variable) const override {
    return scales_[static_cast<std::size_t>(variable)];
  }
  double noise() const override { return noise_; }
  double target() const override { return 10 * noise(); }
  double slowest_rate() const override { return equations_.slowest_rate(); }

 private:
  /// A time of one motion, for the choice of a section.
  struct Stretch {
    double begin, end;
  };

  // Without a direct damper the contact's velocity follows from a_j f_j, not from forces alone.
  std::vector<double> scales() const {
    std::vector<double> list = equations_.scales();
    const Chain& contact = equations_.contact;
    for (std::size_t j = 0; contact.damper == 0 && j < contact.branches.size(); ++j)
      list[equations_.contact_begin() + j] =
          std::min(1.0, contact.branches[j].stiffness / contact.branches[j].rate);
    list.push_back(1);  // the deficit
    return list;
  }

  Period run(const MapState& state, double end, GslIntegrator& integrator) {
    const double begin = section_, longest = &integrator == &asked_ ? longest_switching_step
                                                                    : 2 * longest_switching_step;
    std::vector<double> y(state.y.data(), state.y.data() + state.y.size());
    y.push_back(0);
    ode_.motion = state.motion;
    Rise rise = ode_.adopt(begin, y);
    Period period;
    stretches_ = {{begin, begin}};
    changes_ = 0;
    integrator.begin(begin, std::move(y));
    EventFinder finder(ode_, integrator, 1e-4 * tolerance_);
    while (integrator.time() < end) {
      integrator.step(std::min(end, integrator.time() + longest));
      if (!finder.find(rise)) {
        rise = {};
        continue;
      }
      rise = change(integrator, period);
      stretches_.back().end = integrator.time();
      stretches_.push_back({integrator.time(), end});
    }
    const auto& at_end = integrator.state();
    period.deficit = at_end.back() / two_pi;
    period.end = {Eigen::Map<const Eigen::VectorXd>(at_end.data(), state.y.size()), ode_.motion};
    return period;
  }

  Rise change(GslIntegrator& integrator, Period& period) {
    const Motion before = ode_.motion;
    const Rise rise = ode_.change(integrator.time(), integrator.state());
    integrator.restart();
    const double phase = equations_.phase_at(integrator.time());
    if (ode_.motion != before) period.events.push_back({phase, ode_.motion});
    if (++changes_ > most_changes)
      throw ModelError(fmt::format(
          "chatters: over {} changes in one period, near a phase of {:.4g}", most_changes, phase));
    return rise;
  }

  Equations equations_;
  SwitchingOde ode_;
  StepBudget budget_;
  double tolerance_, noise_;
  std::vector<double> scales_;
  GslIntegrator asked_, coarser_;
  double section_ = 0;
  int changes_ = 0;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::unique_ptr<PeriodMap> switching_map(Method method, const System& system, double velocity,
                                         const MethodOptions& options) {
  return std::make_unique<SwitchingMap>(method, system, velocity, options);
}

}  // namespace vcrit::simulation::methods
