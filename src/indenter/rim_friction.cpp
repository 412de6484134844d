#include "indenter/rim_friction.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "indenter/cell.hpp"
#include "indenter/held_cells.hpp"
#include "indenter/rim_motion.hpp"
#include "indenter/rim_sliding.hpp"
#include "linear/elimination.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::indenter {

namespace {

// On a step: the coarse one tells the error of the fine one, with a thousandth of the tolerance.
// Below the finest all is rounding; where errors of events add up, as in friction, below
// coarse/finer.
constexpr double coarse = 1e-9, finest = 1e-14, finer = 1000;

// Of forces that are about 1, of some hundred steps.
constexpr double force_rounding_error = 1e-14;

// Of the normal force of a half-space with a memory, which is interpolated: relative, and as steps
// of the body below it.
constexpr double fine_force = 1e-12, coarse_force = 1e-8, finest_below = 1e-11;

constexpr int most_newton_steps = 30, most_periods = 400;

constexpr const char* rings =
    "body and drive are in undamped resonance with a harmonic of the normal force, which grows and "
    "shrinks with the contact area: the swing in slip grows without bound";

constexpr const char* nearly_rings =
    "body and drive swing freely at harmonic {} of the oscillation, within a part in 1e10: "
    "rounding decides how far";

constexpr const char* without_bound =
    "where the indenter meets the surface its contact area grows like a root of time, and with it "
    "the "
    "force of the half-space's damper: springs alone follow without bound";

/// The steady motion at one velocity. Periods go by until they repeat. From time to time, Newton's
/// method looks for where they lead: for the numbers of the body, at a phase at which no cell
/// remembers anything, that a period leads back to. There is such a phase, as each cell slides in
/// each period, the centre last, and then all do; or all are off the surface.
class Cycle {
 public:
  Cycle(const ScaledContact& contact, const ScaledHolder& holder, double velocity, double tolerance,
        SharedEffort* whole)
      : periods_(contact, holder, velocity, tolerance, whole),
        trial_(contact, holder, velocity, tolerance, whole),
        first_(trial_.first_given() ? 1 : 0),
        tolerance_(tolerance) {}

  /// From a body at phase 0.
  void find(const StateVector& body) {
    periods_.start(0, body);
    Period before{body, 0, 0};
    double impulse = 0;
    for (int i = 1, alike = 0, next_search = first_search; i <= most_periods; ++i) {
      periods_.show_anew();
      periods_.run(two_pi * i);
      const Period here{periods_.body(), periods_.lack(), periods_.impulse() - impulse};
      impulse = periods_.impulse();
      open_ = here.difference(before);
      alike = open_ <= tolerance_ ? alike + 1 : 0;
      before = here;
      if (alike == enough_alike) {
        impulse_ = here.impulse;
        shown_ = periods_.shown();
        return;
      }
      if (i < next_search) continue;
      next_search *= 2;
      if (go_to_clear(two_pi * i) && search()) return;
    }
    throw ModelError("below the indenter no steady motion is found: its body rings",
                     "give a higher speed; vcrit eval gives the limit of friction at rest");
  }

  double impulse() const { return impulse_; }
  /// What the body's numbers lack at most.
  double open() const { return open_; }
  const Shown& shown() const { return shown_; }

 private:
  struct Period {
    StateVector body;
    double lack, impulse;

    double difference(const Period& other) const {
      return std::max({(body - other.body).lpNorm<Eigen::Infinity>(), std::abs(lack - other.lack),
                       std::abs(impulse - other.impulse)});
    }
  };

  /// Nothing where a cell remembers something in the end.
  std::optional<StateVector> after(const StateVector& body) {
    trial_.start(phase_, body);
    trial_.run(phase_ + two_pi);
    return trial_.clear() ? std::optional(trial_.body()) : std::nullopt;
  }

  bool go_to_clear(double t) {
    if (!(periods_.shown().clear > 0)) return false;
    const double at = periods_.shown().clear_at;
    periods_.run(at + two_pi * std::ceil((t - at) / two_pi));
    if (!periods_.clear()) return false;
    phase_ = at - two_pi * std::floor(at / two_pi);
    body_ = periods_.body();
    return true;
  }

  bool search() {
    known_ = false;
    double least = infinity;
    for (int i = 0, no_better = 0; i < most_newton_steps && no_better < 3; ++i) {
      const std::optional<StateVector> next = after(body_);
      if (!next) return false;
      const StateVector defect = *next - body_;
      const double size = defect.lpNorm<Eigen::Infinity>();
      no_better = size < 0.5 * least ? 0 : no_better + 1;
      if (size < least) {
        least = size;
        impulse_ = trial_.impulse();
        shown_ = trial_.shown();
        open_ = lever_ * size;
      }
      if (size <= tolerance_) return true;
      const std::optional<StateVector> step =
          no_better < 2 ? newton_step(defect, *next) : std::optional(defect);
      if (!step) return false;
      body_ += *step;
    }
    return least <= far_enough * tolerance_;
  }

  // The map that was found last does for what a nudge of it would not see.
  std::optional<StateVector> newton_step(const StateVector& defect, const StateVector& next) {
    const Eigen::Index n = defect.size() - first_;
    StateVector step = StateVector::Zero(defect.size());
    if (n <= 0) return step;
    if (!known_ || defect.lpNorm<Eigen::Infinity>() > far_enough * tolerance_) {
      Eigen::MatrixXd map(n, n);
      for (Eigen::Index i = 0; i < n; ++i) {
        constexpr double nudge = 1e-6;  // the root of what a period is right to
        StateVector moved = body_;
        moved(first_ + i) += nudge;
        const std::optional<StateVector> found = after(moved);
        if (!found) return std::nullopt;
        map.col(i) = -(*found - next).tail(n) / nudge;
        map(i, i) += 1;
      }
      map_ = linear::Lu<double>(map);
      known_ = true;
    }
    step.tail(n) = map_.solve(Eigen::VectorXd(defect.tail(n)));
    lever_ = std::max(1.0, step.lpNorm<Eigen::Infinity>() / defect.lpNorm<Eigen::Infinity>());
    return step;
  }

  static constexpr int first_search = 3, enough_alike = 3;
  static constexpr double far_enough = 1e3;
  RimMotion periods_, trial_;
  Eigen::Index first_;
  double tolerance_;
  bool known_ = false;
  linear::Lu<double> map_;
  double phase_ = 0, impulse_ = 0, open_ = 0, lever_ = 1;
  StateVector body_;
  Shown shown_;
};

/// Both, of one half-space.
class Held {
 public:
  Held(const HalfSpace& half_space, double tolerance)
      : contact_(half_space, tolerance),
        holder_(half_space, contact_),
        effort_(half_space.effort()) {}

  const ScaledContact& contact() const { return contact_; }
  const ScaledHolder& holder() const { return holder_; }
  /// Whether the body swings freely at a harmonic of the normal force. Throws ModelError next to
  /// that.
  bool resonant() const {
    // Of the swing, which is the inverse of the share, four digits are left.
    constexpr double too_near = 1e-10;
    const Relaxation drive{holder_.spring, holder_.damper, holder_.branches};
    if (simulation::free_harmonic(drive, holder_.mass, 1,
                                  simulation::equal_in_roundings * epsilon) > 0)
      return true;
    if (const int n = simulation::nearly_free_harmonic(drive, holder_.mass, 1, too_near); n > 0)
      throw ModelError(fmt::format(nearly_rings, n));
    return false;
  }
  /// Whether the body follows a force that grows without bound, since nothing is in its way.
  bool springs_without_bound() const {
    return contact_.force_rate_unbounded() && !(holder_.mass > 0) && !(holder_.damper > 0);
  }
  std::unique_ptr<Sliding> sliding(double tolerance) const {
    return std::make_unique<Sliding>(contact_, holder_, tolerance, effort_);
  }

  /// Of the body below a drive that moves.
  struct Found {
    double impulse, open;
    Shown shown;
  };
  Found cycle(const Sliding& sliding, double velocity, double tolerance) const {
    Cycle result(contact_, holder_, velocity, tolerance, effort_);
    result.find(sliding.body());
    return {result.impulse(), result.open(), result.shown()};
  }

 private:
  ScaledContact contact_;
  ScaledHolder holder_;
  SharedEffort* effort_;
};

/// Of a drive that carries nothing at rest, N s/m; 0 of another.
double damping_at_rest(const Relaxation& drive) {
  if (drive.equilibrium > 0) return 0;
  double sum = drive.damper;
  for (const MaxwellBranch& branch : drive.branches) sum += branch.stiffness * branch.time;
  return sum;
}

// Cells that are closed at all times carry the least that they ever do, and stick, as long as the
// drive's dampers take less: it creeps as fast as it is moved. The others carry nothing.
FrictionOfSpeed creeping_below(const HalfSpace& half_space, double normal_force,
                               FrictionOfSpeed faster) {
  const double damping = damping_at_rest(half_space.holder()->drive);
  if (damping == 0) return faster;
  const double least = half_space.friction() * half_space.least_force(),
               all = half_space.friction() * normal_force;
  return [=, faster = std::move(faster)](double velocity) {
    const double carried = damping * velocity;
    if (!(carried <= least)) return faster(velocity);
    Friction result;
    result.ratio = carried / all;
    result.error = force_rounding_error;
    result.normal_force = normal_force;
    result.normal_force_error = force_rounding_error * normal_force;
    result.regime = simulation::Regime::stick;
    return result;
  };
}

/// Without an oscillation.
Friction without_oscillation(const HalfSpace& half_space) {
  Friction result;
  result.ratio = 1;
  result.normal_force = half_space.static_force(half_space.indentation());
  result.normal_force_error = force_rounding_error * result.normal_force;
  return result;
}

/// Of a normal force that oscillates.
simulation::Onset threshold_of(const HalfSpace& half_space, const Held& held) {
  const bool elastic = half_space.elastic();
  const double unit = held.contact().speed_unit(), step = elastic ? finest : finest_below;
  if (held.springs_without_bound()) return {infinity, infinity, without_bound};
  if (held.resonant()) return {infinity, infinity, rings};
  const std::optional<Held> other =
      elastic ? std::nullopt : std::optional<Held>(std::in_place, half_space, coarse_force);
  const auto rough = (other ? *other : held).sliding(coarse), sliding = held.sliding(step);
  const double drive = sliding->largest();
  const bool creeps = !(half_space.holder()->drive.equilibrium > 0);
  const double contact = creeps ? drive + sliding->mean_speed() : drive;
  // Where steps are as long as they may be, a hundred thousand times the tolerance changes none;
  // each is good to its own, and they add up.
  const double summed = step * sliding->steps();
  return {contact * unit,
          drive * unit,
          {},
          (std::abs(rough->largest() - drive) + force_rounding_error + summed) * unit};
}

/// By cells in time: so many and so many steps of a period, and then twice and four times both.
FrictionOfSpeed cells_friction(const HalfSpace& half_space, double tolerance) {
  // What is drawn takes a quarter of the time and errs four times as much.
  const int cells = tolerance < drawn_tolerance ? 100 : 50, steps = 6 * cells;
  const auto held = std::make_shared<const Held>(half_space, fine_force);
  if (held->resonant()) throw ModelError(rings);
  const simulation::Onset onset = threshold_of(half_space, *held);
  const double largest = onset.drive_velocity / held->contact().speed_unit();
  // At which all slide, or nearly where none is high enough.
  const double slides = std::isfinite(largest) ? 1.01 * largest : 10;
  std::vector<std::shared_ptr<const HeldCells>> levels;
  for (const int times : {1, 2, 4})
    levels.push_back(std::make_shared<const HeldCells>(half_space, held->contact(), held->holder(),
                                                       times * cells, times * steps));
  const double force = held->sliding(coarse)->mean_force() * held->contact().force_unit();
  FrictionOfSpeed faster = [=, whole = half_space.effort()](double velocity) {
    const double speed = velocity / held->contact().speed_unit();
    Friction result;
    result.normal_force = force;
    result.normal_force_error = coarse_force * force;
    result.ratio = 1;
    result.error = force_rounding_error;
    Motions motions{true, false, false};
    if (speed < largest) {
      std::vector<HeldCells::Steady> found;
      for (const auto& level : levels) found.push_back(level->steady(speed, slides, whole));
      result.ratio = found[2].ratio;
      result.cells = 4 * cells;
      result.error += 2 * (std::abs(found[2].ratio - found[1].ratio) +
                           std::abs(found[1].ratio - found[0].ratio) / 4) +
                      found[2].open;
      motions.stick = true;
      motions.backslip = found[2].backslip;
    }
    result.regime = motions.regime();
    return result;
  };
  return creeping_below(half_space, force, std::move(faster));
}

}  // namespace

FrictionOfSpeed rim_friction(const HalfSpace& half_space, double tolerance) {
  if (!(half_space.amplitude() > 0)) {
    const Friction found = without_oscillation(half_space);
    return creeping_below(half_space, found.normal_force, [found](double) { return found; });
  }
  if (!half_space.elastic()) return cells_friction(half_space, tolerance);
  const double rough = std::max(tolerance, coarse), fine = rough / finer;
  const auto held = std::make_shared<const Held>(half_space, fine_force);
  if (held->resonant()) throw ModelError(rings);
  const std::shared_ptr<const Sliding> sliding = held->sliding(fine);
  FrictionOfSpeed faster = [=, largest = sliding->largest()](double velocity) {
    const double speed = velocity / held->contact().speed_unit();
    Friction result;
    Motions motions{true, false, false};
    result.normal_force = sliding->mean_force() * held->contact().force_unit();
    result.normal_force_error = force_rounding_error * result.normal_force;
    result.ratio = 1;
    result.error = force_rounding_error;
    if (speed < largest) {
      const double all = two_pi * sliding->mean_force();
      const double share = std::min(1.0, 1e3 * speed);
      const Held::Found before = held->cycle(*sliding, speed, share * rough),
                        found = held->cycle(*sliding, speed, share * fine);
      result.ratio = found.impulse / all;
      result.error += std::abs(before.impulse / all - result.ratio) + found.open / all;
      motions.stick = found.shown.stick;
      motions.backslip = found.shown.backslip;
    }
    result.regime = motions.regime();
    return result;
  };
  return creeping_below(half_space, sliding->mean_force() * held->contact().force_unit(),
                        std::move(faster));
}

simulation::Onset rim_threshold(const HalfSpace& half_space) {
  if (!(half_space.amplitude() > 0)) {
    simulation::Onset still;
    const double damping = damping_at_rest(half_space.holder()->drive);
    if (damping > 0)
      still.drive_velocity =
          half_space.friction() * half_space.static_force(half_space.indentation()) / damping;
    return still;
  }
  return threshold_of(half_space, Held(half_space, fine_force));
}

}  // namespace vcrit::indenter
