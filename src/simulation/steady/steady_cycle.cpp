#include "simulation/steady/steady_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/motion/course.hpp"
#include "simulation/steady/closing.hpp"
#include "simulation/steady/far_apart.hpp"
#include "simulation/steady/full_friction.hpp"
#include "simulation/steady/near_resonance.hpp"
#include "simulation/steady/shooting.hpp"
#include "simulation/system/drive_rounding.hpp"

namespace vcrit::simulation {

namespace {

// The share of the residual by which a step may miss what was expected of it.
constexpr double good_miss = 0.3;

// In rounding errors: a residual of so many may be rounding, too, if the ratio does not notice it.
// That does not tell whether the cycle sticks, so near to v*; there a residual is no more than one.
constexpr double nearly = 1e3, strictly = 1;

// Where rounding errors would grow beyond this, no digits of the motion are left to speak of.
constexpr double fastest_creep = 1e7, most_unlike = 1e7;

// So far below v* a stick is lost where rounding hides the whole motion, not where it is short.
constexpr double most_without_stick = 1e-2;

void check_reach(const Model& model) {
  check_settles(model);
  check_closings(model);
  if (lost_in_resonance(model))
    throw ModelError(
        model.resonance < infinity
            ? "body and drive are so near an undamped resonance that their swing is lost in "
              "rounding"
            : "body and drive are in undamped resonance: the swing in slip grows without bound");
  if (!(model.unlike < most_unlike)) parts_too_different();
  // A contact that opens excites harmonics as well, even where the first harmonic moves nothing.
  const double swing =
      std::max(std::abs(model.sliding_velocity), model.opening ? model.amplitude : 0);
  if (!(model.creep == 0 || model.creep < fastest_creep * swing))
    throw ModelError(
        "drive and contact creep ten million times faster than the contact swings: its "
        "velocity is lost in rounding");
}

// How much Newton's steps are damped: less after a good one, unless it was just raised.
struct Damping {
  double value = 0;

  void lower(double miss) {
    if (raised_)
      raised_ = false;
    else if (value < least)
      value = 0;
    else
      value *= std::max(0.03, std::sqrt(miss / good_miss));
  }
  void raise(double miss) {
    if (value == 0)
      value = std::exchange(first_, 10 * least);
    else
      value *= std::clamp(std::sqrt(miss / good_miss), 2.0, 10.0);
    raised_ = true;
  }

 private:
  static constexpr double least = 1e-9;
  double first_ = 1e-4;
  bool raised_ = false;
};

// From rest, a body on a stiff drive rings, and sticks and slips with every ring until that has
// died away, if it does. As the friction does not depend on the start, one that takes more than
// this is left.
struct Patience {
  int attempts;
  std::size_t parts;  ///< of a period
};
constexpr Patience usual_patience{8, 200}, last_patience{16, most_parts};

class SteadyCycleSearch {
 public:
  SteadyCycleSearch(const Model& model, double velocity, State start,
                    const Patience& patience = usual_patience, double enough = nearly)
      : model_(model),
        velocity_(velocity),
        patience_(patience),
        enough_(enough),
        state_(std::move(start)) {}

  /// There is one, or ModelError.
  std::optional<SteadyCycle> run() {
    int cycles = 1;
    for (int attempt = 0; attempt < patience_.attempts; ++attempt) {
      const bool patient = attempt >= easy_attempts;
      for (int i = 0; i < cycles; ++i) plain_period();
      if (auto cycle = closed(patient)) return cycle;
      if (last_.parts.size() == 1) load();
      if (patient && cycles < 1000) cycles *= 2;
    }
    throw ModelError("no steady state found: the motion still drifts after thousands of periods");
  }

  std::optional<SteadyCycle> from(Trace near) {
    last_ = std::move(near);
    state_ = last_.end;
    return closed(false);
  }

 private:
  static constexpr int easy_attempts = 4;
  static constexpr int most_steps = 200;

  void plain_period() {
    ++traced_;
    last_ = trace(model_, velocity_, state_, two_pi, {}, patience_.parts);
    state_ = last_.end;
  }

  // The steady cycle, if it is near the last period. Slip alone has no events to shoot at.
  std::optional<SteadyCycle> closed(bool patient) {
    if (model_.opening || (last_.parts.size() == 1 && state_.motion == Motion::slip))
      return newton(patient);
    const auto course = course_of(last_);
    if (!course) return std::nullopt;
    const auto hit = shoot(model_, velocity_, *course);
    if (!hit && !patient) return std::nullopt;
    state_ = hit.value_or(in_slip(*course));
    return newton(patient);
  }

  // The middle of a course's first slip.
  State in_slip(const Course& course) const {
    State state = Piece(model_, velocity_, course.start).after(0.5 * course.legs.front().duration);
    state.at = state.at.time - two_pi * std::floor(state.at.time / two_pi);
    state.x[0] = model_.slip_force(1, state.at);  // whatever phase was lost on the way from rest
    return state;
  }

  // From rest, or after a slip too far, the drive may pull for many periods before anything slips.
  void load() { state_ = next_event_state(model_, velocity_, state_, 1e12); }

  // The period map from a state in slip on, back into slip, and what is left to close the cycle.
  struct Mapped {
    Mapped(const Model& model, double velocity, const State& state)
        : trace(simulation::trace(model, velocity, state, two_pi,
                                  unit_changes(state, state.x.size() - 1))) {}

    Trace trace;
    Closing left;     // not yet: an initialiser would clear the room of its numbers
    double size = 0;  ///< of the residual, in units of its rounding error
    const State& start() const { return trace.parts.front().piece.start(); }
  };

  std::optional<Mapped> mapped(const State& state) {
    const Motion section = model_.opening ? Motion::separated : Motion::slip;
    if (section == Motion::slip && contact_velocity(model_, velocity_, state) <= 0)
      return std::nullopt;
    return mapped(state, section);
  }

  // Traces are large: they are made where they stay, and an empty room for one would be cleared.
  std::optional<Mapped> mapped(const State& state, Motion section) {
    ++traced_;
    std::optional<Mapped> result(std::in_place, model_, velocity_, state);
    if (result->trace.end.motion == section) {
      result->left = closing(model_, state, result->trace);
      result->size = size(result->left.residual, state);
    } else {
      result.reset();
    }
    return result;
  }

  // In units of rounding errors.
  double size(const Vector& residual, const State& state) const {
    const Vector unit = rounding(model_, velocity_, state);
    double largest = 0;
    for (Index i = 0; i < unit.size(); ++i)
      largest = std::max(largest, std::abs(residual[i] / unit[i]));
    return largest;
  }

  Vector size_of(const Mapped& now) const { return state_size(model_, velocity_, now.start()); }

  static State corrected(State state, const Vector& step) {
    for (Index i = 1; i < state.x.size(); ++i) state.x[i] += step[i - 1];
    return state;
  }

  // What damping leaves of the residual after a step.
  static Vector left_over(const Mapped& now, double damping, const Vector& step) {
    Vector result(step.size());
    add_product(now.left.identity, step, result);
    for (double& value : result) value *= damping;
    return result;
  }

  // Newton's method, damped where the map bends: with a weight d on the identity a step goes as far
  // as 1/d plain cycles along slow directions, and d times the step is what the residual should be
  // after it. As no cycle moves two motions apart, such steps lead to the fixed point from
  // anywhere.
  std::optional<SteadyCycle> newton(bool patient) {
    std::optional<Mapped> now = mapped(state_);
    Damping damping;
    double last_moved = infinity;
    for (int i = 0; i < most_steps && now && damping.value < 10; ++i) {
      if (now->size <= 1) return finished(std::move(*now));
      if (damping.value == 0) {
        if (auto hit = shot_from(*now); hit && hit->size <= good_miss * now->size) {
          state_ = hit->start();
          now = std::move(hit);
          continue;
        }
      }
      const Vector step = counted_solver(model_, damped(now->left, damping.value), size_of(*now))
                              .solve(now->left.residual);
      if (!std::isfinite(sum_of_sizes(step))) return std::nullopt;
      std::optional<Mapped> trial = mapped(corrected(state_, step));
      const double miss = missed(*now, trial, left_over(*now, damping.value, step));
      if (miss <= good_miss) {
        state_ = trial->start();
        now = std::move(trial);
        damping.lower(miss);
      } else if (now->size <= enough_ && moved(*now, trial) <= error(*now).rounding) {
        return finished(std::move(*now));
      } else if (!patient) {
        return std::nullopt;
      } else {
        last_moved = moved(*now, trial);
        if (!trial) now = centred(*now);
        damping.raise(miss);
      }
    }
    if (patient && now && now->size <= enough_) return finished(std::move(*now), last_moved);
    return std::nullopt;
  }

  // The period map from where shooting along the last period's course leads.
  std::optional<Mapped> shot_from(const Mapped& now) {
    if (model_.opening) return std::nullopt;
    const auto course = course_of(now.trace);
    const auto hit = course ? shoot(model_, velocity_, *course) : std::nullopt;
    return hit ? mapped(*hit) : std::nullopt;
  }

  static Matrix damped(const Closing& left, double damping) {
    Matrix result = left.derivative;
    for (Index j = 0; j < result.columns(); ++j)
      for (Index i = 0; i < result.rows(); ++i) result(i, j) += damping * left.identity(i, j);
    return result;
  }

  // By what share of the residual a step misses what was expected of it.
  double missed(const Mapped& now, const std::optional<Mapped>& trial, Vector expected) const {
    if (!trial) return infinity;
    for (Index i = 0; i < expected.size(); ++i) expected[i] = trial->left.residual[i] - expected[i];
    return size(expected, state_) / now.size;
  }

  // By how much a step moves the friction ratio.
  static double moved(const Mapped& now, const std::optional<Mapped>& trial) {
    return trial ? std::abs(trial->trace.impulse() - now.trace.impulse()) / two_pi : infinity;
  }

  // The slip may have moved away from the stroboscope on the way.
  std::optional<Mapped> centred(const Mapped& now) {
    if (model_.opening) return mapped(now.start());
    if (const auto course = course_of(now.trace)) state_ = in_slip(*course);
    return mapped(state_);
  }

  // What one more Newton step would change, and the rounding of one period as the steady state
  // amplifies it, with that of the mean itself, a few errors for each of its parts.
  struct Error {
    double change, rounding;
  };
  Error error(const Mapped& now) const {
    const LinearSolver solver = counted_solver(model_, now.left.derivative, size_of(now));
    const Vector step = solver.solve(now.left.residual);
    const Matrix& changes = now.trace.changes.integrals;
    Vector gradient;
    for (Index j = 0; j < changes.columns(); ++j) gradient.push_back(changes(0, j));
    const Vector gain = solver.solve_transposed(gradient);
    const Vector unit = rounding(model_, velocity_, now.start());
    double change = 0, rounded = 0;
    for (Index i = 0; i < step.size(); ++i) {
      change += gradient[i] * step[i];
      rounded += std::abs(gain[i]) * unit[i];
    }
    const double summing =
        8 * epsilon * model_.force_size() * static_cast<double>(now.trace.parts.size());
    return {std::abs(change) / two_pi, summing + rounded / two_pi};
  }

  // Below the threshold a cycle that only slips is one whose stick is lost in rounding: no error of
  // its own tells of that. The ratio is taken not to be below that of the speeds: proved without a
  // body, where friction is concave in speed, an estimate with one. What passes outside the law
  // moves forces by no more than its time. All ratios lie between 1 - a and 1, and near a free
  // swing of the body closer to 1.
  std::optional<SteadyCycle> finished(Mapped&& now, double more = 0) const {
    if (now.trace.parts.size() == 1) {
      more = 1 - velocity_ / model_.threshold;
      if (more > most_without_stick)
        throw ModelError(
            "below the critical velocity the contact sticks in every period, but here its stick is "
            "lost in rounding: the scene's times or stiffnesses lie too far apart for its motion");
    }
    const double ratio = model_.load + now.trace.impulse() / two_pi;
    const auto [change, rounding] = error(now);
    // The contact's velocity is the small difference of the drive's and the creep.
    const double creeping =
        model_.opening ? 0 : 2 * epsilon * model_.creep / model_.threshold * model_.amplitude;
    const double sum = epsilon + creeping + change + rounding + more + now.trace.unlawful +
                       model_.bound_error() + model_.merging;
    return std::optional<SteadyCycle>(std::in_place, std::move(now.trace), ratio,
                                      at_most(sum, ratio), traced_);
  }

  // No error is larger than what friction may be off at all, which takes a response of the drive.
  double at_most(double error, double ratio) const {
    const double range = model_.opening ? 1 : model_.amplitude, from_full = std::abs(1 - ratio);
    if (error < std::min(range, from_full)) return error;
    const double missing = most_missing_friction(model_, velocity_);
    const double most = std::min(range, std::max(from_full, std::abs(ratio - 1 + missing)));
    return error < most ? error : most;
  }

  const Model& model_;
  double velocity_;
  Patience patience_;
  double enough_;  ///< within so many rounding errors, where steps lead no further
  State state_;
  Trace last_;
  int traced_ = 0;
};

}  // namespace

namespace {

std::optional<SteadyCycle> searched(const Model& model, double velocity, State start,
                                    const Patience& patience, double enough) try {
  return SteadyCycleSearch(model, velocity, std::move(start), patience, enough).run();
} catch (const ModelError&) {
  return std::nullopt;
}

// From the given start, and where that does not settle from both of ours.
std::optional<SteadyCycle> searched(const Model& model, double velocity, State start,
                                    double enough) {
  model.effort.renew(effort_of_state);
  std::optional<SteadyCycle> found =
      searched(model, velocity, std::move(start), usual_patience, enough);
  if (!found)
    found = searched(model, velocity, sliding_start(model, velocity), last_patience, enough);
  return found;
}

}  // namespace

SteadyCycle steady_cycle(const Model& model, double velocity, State start) {
  check_reach(model);
  if (auto found = searched(model, velocity, std::move(start), nearly)) return *std::move(found);
  try {
    return *SteadyCycleSearch(model, velocity, rest_start(model, velocity), last_patience).run();
  } catch (const ModelError& last) {
    no_motion_found(model, velocity, last);
  }
}

std::optional<SteadyCycle> strictly_steady_cycle(const Model& model, double velocity, State start) {
  check_reach(model);
  if (auto found = searched(model, velocity, std::move(start), strictly)) return found;
  return searched(model, velocity, rest_start(model, velocity), last_patience, strictly);
}

std::optional<SteadyCycle> steady_cycle_near(const Model& model, double velocity,
                                             const SteadyCycle& other) try {
  model.effort.renew(effort_of_state);
  return SteadyCycleSearch(model, velocity, other.period.end).from(other.period);
} catch (const ModelError&) {
  return std::nullopt;
}

}  // namespace vcrit::simulation
