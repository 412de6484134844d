#include "simulation/steady/answers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/rounded.hpp"
#include "modes/beyond_doubles.hpp"
#include "simulation/steady/near_resonance.hpp"

namespace vcrit::simulation {

namespace {

// One steady state in the user's units, in the memory of another.
class Answer {
 public:
  Answer(const Model& model, double velocity, int samples, SteadyState& state)
      : model_(model), velocity_(velocity), samples_(samples), state_(state) {
    state_.events.clear();
    state_.cycle.clear();
    state_.periods = 1;
    state_.other_start.reset();
  }

  // F is mu0 F_n throughout, so the ratio is 1 by the balance of forces alone.
  void sliding() const {
    using namespace std::complex_literals;
    set(1, 0, Regime::sliding);
    for (int i = 0; i < samples_; ++i) {
      const double t = phase_of(i) + model_.phase;
      const double slowest = t + std::arg(model_.sliding_velocity) + pi;
      double velocity = velocity_ + (model_.sliding_velocity * std::exp(1i * t)).real();
      for (const auto& [harmonic, amplitude] : model_.free_swings)
        velocity += amplitude * std::cos(harmonic * slowest);
      state_.cycle.push_back(point(phase_of(i), velocity, model_.bound(t), model_.bound(t)));
    }
  }

  // The path carries eta v0, which the velocity of the motion, v0 less the creep, has lost where v0
  // is small.
  void stick(double drive_velocity) const {
    const double force = drive_velocity / model_.creep;
    set(force, 8 * 2.3e-16 * force, Regime::stick);
    for (int i = 0; i < samples_; ++i) {
      const double bound = model_.bound(phase_of(i) + model_.phase);
      state_.cycle.push_back(point(phase_of(i), 0, force, bound));
    }
  }

  void cycle(const SteadyCycle& found) const {
    list_events(found.period);
    set(found.ratio, found.error, regime(state_.events));
    for (int i = 0; i < samples_; ++i) state_.cycle.push_back(sample(found.period, phase_of(i)));
  }

 private:
  void set(double ratio, double error, Regime regime) const {
    state_.friction_ratio = ratio;
    state_.friction_ratio_error = error;
    state_.regime = regime;
  }

  void list_events(const Trace& period) const {
    std::vector<Event>& list = state_.events;
    for (std::size_t i = 1; i < period.parts.size(); ++i) {
      const State& start = period.parts[i].piece.start();
      if (start.motion == period.parts[i - 1].piece.start().motion) continue;
      list.push_back({wrapped(start.at.time - model_.phase), start.motion});
    }
    std::sort(list.begin(), list.end(),
              [](const Event& a, const Event& b) { return a.phase < b.phase; });
  }

  static Regime regime(const std::vector<Event>& events) {
    const auto there = [&](Motion motion) {
      return std::any_of(events.begin(), events.end(),
                         [&](const Event& event) { return event.to == motion; });
    };
    const bool separated = there(Motion::separated);
    if (there(Motion::backslip))
      return separated ? Regime::stick_slip_backslip_separated : Regime::stick_slip_backslip;
    if (there(Motion::stick)) return separated ? Regime::stick_slip_separated : Regime::stick_slip;
    return separated ? Regime::sliding_separated : Regime::sliding;
  }

  double phase_of(int sample) const { return two_pi * sample / samples_; }

  CyclePoint point(double phase, double velocity, double force, double bound) const {
    return {phase, velocity * model_.velocity_unit, force * model_.force_unit,
            bound * model_.force_unit};
  }

  CyclePoint sample(const Trace& period, double phase) const {
    const double begin = period.parts.front().piece.start().at.time;
    const double t = begin + wrapped(phase + model_.phase - begin);
    auto part = period.parts.begin();
    while (std::next(part) != period.parts.end() && std::next(part)->piece.start().at.time <= t)
      ++part;
    const double duration = t - part->piece.start().at.time;
    const State state = part->piece.after(duration);
    return point(
        phase, contact_velocity(model_, velocity_, state), model_.load + state.x[0],
        state.motion == Motion::separated ? 0 : model_.bound(phase + model_.phase, state.touch));
  }

  const Model& model_;
  double velocity_;
  int samples_;
  SteadyState& state_;
};

State started(const Model& model, double velocity, Start start) {
  return start == Start::sliding ? sliding_start(model, velocity) : rest_start(model, velocity);
}

}  // namespace

Answers::Answers(const System& system) : model_(system) {
  state_.events.reserve(usual_events);
  if (model_.opening) other_state_.events.reserve(usual_events);
  if (lost_in_resonance(model_)) near_resonance_ = system;
  nearly_free_ = nearly_free_harmonic(system);
}

const SteadyState& Answers::alone(double velocity, Start start, int samples) {
  answer(velocity, start, samples, false);
  return state_;
}

const SteadyState& Answers::at(double velocity, Start start, int samples) {
  answer(velocity, start, samples, false);
  require_doubles(std::isfinite(state_.friction_ratio));
  compare_starts(velocity, start == Start::rest ? Start::sliding : Start::rest);
  return state_;
}

const SteadyState& Answers::next(double velocity) {
  answer(velocity, Start::sliding, 0, true);
  require_doubles(std::isfinite(state_.friction_ratio));
  compare_starts(velocity, Start::rest);
  return state_;
}

void Answers::answer(double velocity, Start start, int samples, bool near_last) {
  require_forward(velocity);
  const double v = model_.motion_velocity(velocity / model_.velocity_unit);
  const Answer result(model_, v, samples, state_);
  if (model_.slides(v)) return result.sliding();
  if (model_.never_slips(v)) return result.stick(velocity / model_.velocity_unit);
  if (near_resonance_) return answer_near_resonance(velocity, v, start, samples);
  if (!near_last || !follow(v)) {
    last_.reset();
    last_.emplace(searched(v, start));
  }
  traced_periods_ += last_->traced;
  return result.cycle(*last_);
}

void Answers::answer_near_resonance(double velocity, double motion_velocity, Start start,
                                    int samples) {
  const Neighbours all = neighbours(*near_resonance_, model_, motion_velocity);
  std::array<SteadyState, 4> states;
  for (std::size_t i = 0; i < states.size(); ++i) {
    Answers neighbour(all.systems[i]);
    if (neighbour.near_resonance_) too_fast_for_neighbours();
    states[i] = neighbour.at(velocity, start, samples);
    traced_periods_ += neighbour.traced_periods();
  }
  state_ = between(all, states);
}

// Next to a free harmonic sliding takes little to keep its swing: sticks are as short as the drive
// is near to it, and a search may not find them.
SteadyCycle Answers::searched(double motion_velocity, Start start) const {
  const double border = nearly_free_ > 1 ? std::cos(pi / (2 * nearly_free_)) : 1;
  try {
    return steady_cycle(model_, motion_velocity, started(model_, motion_velocity, start));
  } catch (const ModelError& error) {
    const double creep = model_.creep * model_.load;
    if (model_.opening || motion_velocity < border * model_.threshold) throw;
    throw ModelError(
        fmt::format("{}; the body swings nearly freely at harmonic {} of the oscillation, within a "
                    "part in 1e5: from {}, v* cos(pi/{}), to v* it slides but for sticks as "
                    "short as that, with nearly full friction",
                    error.what(), nearly_free_,
                    rounded((border * model_.threshold + creep) * model_.velocity_unit, "m/s"),
                    2 * nearly_free_),
        "give a speed outside this range, or a drive at the harmonic or farther from it");
  }
}

// Friction does not depend on the start. Where the two differ by more than their errors, one search
// has stopped short of the steady state, and either may be off by that.
void Answers::compare_starts(double velocity, Start other) {
  if (!model_.opening) return;
  const double v = model_.motion_velocity(velocity / model_.velocity_unit);
  other_.reset();
  other_.emplace(steady_cycle(model_, v, started(model_, v, other)));
  traced_periods_ += other_->traced;
  Answer(model_, v, 0, other_state_).cycle(*other_);
  double& error = state_.friction_ratio_error;
  const double difference = std::abs(other_state_.friction_ratio - state_.friction_ratio);
  const double both = error + other_state_.friction_ratio_error;
  state_.other_start = {other_state_.friction_ratio, other_state_.friction_ratio_error,
                        other_state_.regime, difference <= both};
  if (!state_.other_start->agrees) error = difference + other_state_.friction_ratio_error;
}

bool Answers::follow(double velocity) {
  if (!last_) return false;
  auto cycle = steady_cycle_near(model_, velocity, *last_);
  if (!cycle) return false;
  last_ = std::move(cycle);
  return true;
}

}  // namespace vcrit::simulation
