#include "compare/held_cells.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::validation {

namespace {

using indenter::HalfSpace;

/// Place and speed of the body behind the moving drive, then a force for each relaxing spring.
using HeldBody = Eigen::VectorXd;

/// What cells of a viscoelastic half-space remember, across the surface and along it: springs and
/// relaxing ones, whose ends move evenly over a step. While a cell is off the surface nothing
/// presses it.
class MemorySteps {
 public:
  MemorySteps(const Relaxation& modulus, double step, std::size_t cells, double width)
      : spring_(width * modulus.equilibrium),
        damper_(width * modulus.damper / step),
        across_(cells * (modulus.branches.size() + 1)),
        along_(across_.size()),
        places_(cells),
        pressed_(cells) {
    left_.push_back(1);
    gained_.push_back(spring_);
    for (const MaxwellBranch& branch : modulus.branches) {
      const double lasts = branch.time / step;
      left_.push_back(std::exp(-1 / lasts));
      gained_.push_back(width * branch.stiffness * lasts * (1 - left_.back()));
    }
    at_once_ = damper_;
    for (const double each : gained_) at_once_ += each;
  }

  double at_once() const { return at_once_; }
  double pressed(std::size_t i) const { return pressed_[i]; }
  double relaxed(std::size_t i) const { return carried(along_, i); }

  void press(double depth, const std::vector<double>& gaps) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double before = carried(across_, i), free = places_[i] - before / at_once_;
      const double place = std::max(depth - gaps[i], free), way = place - places_[i];
      pressed_[i] = std::max(0.0, before + at_once_ * way);
      move(across_, i, 1, way);
      places_[i] = place;
    }
  }

  void shear(std::size_t i, double ratio, double way) { move(along_, i, ratio, way); }

 private:
  double carried(const std::vector<double>& forces, std::size_t i) const {
    double sum = 0;
    for (std::size_t j = 0; j < left_.size(); ++j) sum += left_[j] * forces[i * left_.size() + j];
    return sum;
  }

  void move(std::vector<double>& forces, std::size_t i, double ratio, double way) {
    for (std::size_t j = 0; j < left_.size(); ++j) {
      double& force = forces[i * left_.size() + j];
      force = left_[j] * force + ratio * gained_[j] * way;
    }
  }

  double spring_, damper_, at_once_ = 0;
  std::vector<double> left_, gained_, across_, along_, places_, pressed_;
};

/// Balance of a step, by which the body moves by d: drive and inertia take `slope` d + `rest`, and
/// what is left, `share` of it, are the cells.
class HeldSteps {
 public:
  HeldSteps(const HalfSpace& half_space, double velocity, int cells, int steps)
      : half_space_(half_space),
        holder_(half_space.holder().value()),
        steps_(steps),
        step_(two_pi / half_space.omega() / steps),
        driven_(velocity * step_),
        // A body or a damper is balanced over the step; springs alone, which have no rate, at its
        // end.
        share_(holder_.mass > 0 || holder_.drive.damper > 0 ? 0.5 : 1),
        forces_(static_cast<std::size_t>(cells)),
        most_(forces_.size()),
        relaxed_(forces_.size()) {
    const double width = half_space.edge() / cells;
    for (int i = 0; i < cells; ++i) gaps_.push_back(half_space.gap().at((i + 0.5) * width));
    stiffness_ = 2 * width * half_space.static_modulus();
    slope_ = 2 * holder_.mass / (step_ * step_) + holder_.drive.damper / step_ +
             share_ * holder_.drive.equilibrium;
    for (const MaxwellBranch& branch : holder_.drive.branches) {
      left_.push_back(std::exp(-step_ / branch.time));
      gained_.push_back(branch.stiffness * branch.time / step_ * (1 - left_.back()));
      slope_ += share_ * gained_.back();
    }
    if (!half_space.elastic()) memory_.emplace(half_space.normal(), step_, gaps_.size(), 2 * width);
  }

  Eigen::Index size() const { return 2 + static_cast<Eigen::Index>(left_.size()); }

  /// Below the mean friction of a body that slides.
  HeldBody first() const {
    HeldBody body = HeldBody::Zero(size());
    double mean = 0;
    for (const double gap : gaps_)
      mean += half_space_.friction() * stiffness_ * std::max(0.0, half_space_.indentation() - gap);
    body(0) = -mean / holder_.drive.equilibrium;
    return body;
  }

  /// A period on from phase 0; the cells go on from where they are.
  HeldBody period(HeldBody body) {
    friction_ = bound_ = 0;
    sticks_ = false;
    for (int i = 1; i <= steps_; ++i) {
      const double t = two_pi * i / steps_;
      depth_ = half_space_.indentation() + half_space_.amplitude() * std::cos(t);
      if (memory_) memory_->press(depth_, gaps_);
      move(body);
    }
    return body;
  }

  HeldMarch result() const { return {friction_ / bound_, sticks_}; }

 private:
  struct Pull {
    double force = 0, slope = 0;
  };

  /// What a cell resists a step by, over its length.
  double at_once() const { return memory_ ? memory_->at_once() : stiffness_; }

  double bound(std::size_t i) const {
    if (memory_) return half_space_.friction() * memory_->pressed(i);
    return half_space_.friction() * stiffness_ * std::max(0.0, depth_ - gaps_[i]);
  }

  /// What each cell carries at most, and along if it stands still: of a step, whatever d is.
  void begin_step() {
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      most_[i] = bound(i);
      relaxed_[i] = memory_ ? memory_->relaxed(i) : forces_[i];
    }
  }

  /// Of all cells, after the body has moved by d.
  Pull pull(double d) const {
    const double spring = half_space_.shear_ratio() * at_once(), moved = spring * (d + driven_);
    Pull all;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const double most = most_[i], force = relaxed_[i] + moved;
      all.force += std::min(std::max(force, -most), most);
      all.slope += std::abs(force) < most ? spring : 0.0;
    }
    return all;
  }

  // Newton's method: all is made of straight pieces and rises.
  void move(HeldBody& body) {
    double rest = -2 * holder_.mass / step_ * body(1) + holder_.drive.equilibrium * body(0) +
                  (1 - share_) * force_;
    for (std::size_t j = 0; j < left_.size(); ++j)
      rest += (1 - share_ + share_ * left_[j]) * body(2 + static_cast<Eigen::Index>(j));
    begin_step();
    constexpr int most_corrections = 60;
    double d = 0, piece = -1;
    for (int i = 0; i < most_corrections; ++i) {
      const Pull cells = pull(d);
      d -= (slope_ * d + rest + share_ * cells.force) / (slope_ + share_ * cells.slope);
      if (cells.slope == piece) break;  // the same straight piece as before, and so its root
      piece = cells.slope;
    }
    body(0) += d;
    // Without a mass nothing rests on it.
    body(1) = holder_.mass > 0 ? 2 * d / step_ - body(1) : d / step_;
    for (std::size_t j = 0; j < left_.size(); ++j) {
      double& force = body(2 + static_cast<Eigen::Index>(j));
      force = left_[j] * force + gained_[j] * d;
    }
    note(d);
  }

  void note(double d) {
    const double spring = half_space_.shear_ratio() * at_once(), moved = spring * (d + driven_);
    force_ = 0;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const double most = most_[i], before = relaxed_[i];
      forces_[i] = std::clamp(before + moved, -most, most);
      if (memory_) memory_->shear(i, half_space_.shear_ratio(), (forces_[i] - before) / spring);
      force_ += forces_[i];
      bound_ += most;
      sticks_ = sticks_ || std::abs(forces_[i]) < most * (1 - at_bound);
    }
    friction_ += force_;
  }

  static constexpr double at_bound = 1e-9;  // relative: of sums in doubles

  const HalfSpace& half_space_;
  const indenter::Holder& holder_;
  int steps_;
  double step_, driven_, share_;
  std::vector<double> gaps_, forces_, most_, relaxed_, left_, gained_;
  std::optional<MemorySteps> memory_;  ///< none of an elastic half-space
  double stiffness_ = 0, slope_ = 0, depth_ = 0, force_ = 0;
  double friction_ = 0, bound_ = 0;
  bool sticks_ = false;
};

// Relative, of a period's way: below what steps and cells err by.
constexpr double repeats = 1e-9;
constexpr int most_periods_of_cells = 40;

/// Numbers of a body in the lengths and forces that they have, to be told apart from rounding.
double held_size(const HalfSpace& half_space, const HeldBody& change) {
  const indenter::Holder& holder = half_space.holder().value();
  double size = std::max(std::abs(change(0)), std::abs(change(1)) / half_space.omega());
  for (Eigen::Index j = 2; j < change.size(); ++j)
    size = std::max(size, std::abs(change(j)) /
                              holder.drive.branches[static_cast<std::size_t>(j - 2)].stiffness);
  return size;
}

}  // namespace

// A cell that opens forgets in the time that it is off the surface, or soon after: what it
// remembers fades by a period's share of its relaxation. One that never opens has the sum of its
// mean and of its answer to the oscillation, and takes no part in the march.
std::vector<double> pressed_in_steps(const HalfSpace& half_space, int cells, int steps) {
  const double omega = half_space.omega(), width = half_space.edge() / cells;
  const std::complex<double> swing =
      half_space.amplitude() * dynamic_stiffness(half_space.normal(), omega);
  std::vector<double> gaps, force(static_cast<std::size_t>(steps));
  const auto phase = [&](int i) { return two_pi * i / steps; };
  for (int i = 0; i < cells; ++i) {
    const double x = (i + 0.5) * width;
    if (!half_space.stays_closed(x)) {
      gaps.push_back(half_space.gap().at(x));
      continue;
    }
    for (int j = 0; j < steps; ++j)
      force[static_cast<std::size_t>(j)] += 2 * width *
                                            (half_space.static_modulus() * half_space.depth(x) +
                                             (swing * std::polar(1.0, phase(j))).real());
  }
  MemorySteps memory(half_space.normal(), two_pi / omega / steps, gaps.size(), 2 * width);
  std::vector<double> opening(force.size());
  for (int i = 0; i < most_periods_of_cells; ++i) {
    double largest = 0, change = 0;
    for (int j = 1; j <= steps; ++j) {
      memory.press(half_space.indentation() + half_space.amplitude() * std::cos(phase(j)), gaps);
      double sum = 0;
      for (std::size_t k = 0; k < gaps.size(); ++k) sum += memory.pressed(k);
      double& before = opening[static_cast<std::size_t>(j % steps)];
      change = std::max(change, std::abs(sum - before));
      largest = std::max(largest, sum);
      before = sum;
    }
    if (change > repeats * largest) continue;
    for (std::size_t j = 0; j < force.size(); ++j) force[j] += opening[j];
    return force;
  }
  throw ModelError("what cells remember takes too many periods to fade");
}

// Periods, and between them Newton's method for the body's numbers that one leads back to: a body
// that is hardly damped rings for thousands of periods. What the cells remember is gone after one,
// since each slides in it.
HeldMarch march_held_cells(const HalfSpace& half_space, double velocity, int cells, int steps) {
  HeldSteps motion(half_space, velocity, cells, steps);
  HeldBody body = motion.first();
  body = motion.period(body);
  const double way = half_space.amplitude() + velocity / half_space.omega();
  Eigen::MatrixXd map;
  for (int i = 0; i < most_periods_of_cells; ++i) {
    const HeldBody next = motion.period(body), lack = next - body;
    if (held_size(half_space, lack) <= repeats * way) return motion.result();
    if (i % 4 == 0) {  // anew from time to time, as it changes with where cells stick
      const HeldSteps before = motion;
      map = Eigen::MatrixXd::Identity(lack.size(), lack.size());
      for (Eigen::Index j = 0; j < lack.size(); ++j) {
        HeldBody unit = HeldBody::Zero(lack.size());
        const double nudge = 1e-5 * way;  // far above rounding, far below a stick
        unit(j) =
            nudge *
            (j == 0 ? 1
             : j == 1
                 ? half_space.omega()
                 : half_space.holder()->drive.branches[static_cast<std::size_t>(j - 2)].stiffness);
        HeldSteps tried = before;
        const HeldBody base = tried.period(next);
        HeldSteps moved = before;
        map.col(j) -= (moved.period(next + unit) - base) / unit(j);
      }
    }
    body = next + linear::PivotedQr(map).solve(motion.period(next) - next);
  }
  throw ModelError("the march of plain cells finds no motion that repeats");
}

}  // namespace vcrit::validation
