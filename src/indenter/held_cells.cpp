#include "indenter/held_cells.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "linear/orthogonal.hpp"
#include "simulation/system/effort.hpp"

namespace vcrit::indenter {

namespace {

// Straight pieces of a balance of many cells: a handful is passed.
constexpr int most_pieces = 200;

// Periods until all cells slide, from none that is deformed.
constexpr int first_periods = 3;

constexpr int most_marched = 400;

// Of forces that are about 1 in all: far below what cells and steps err by.
constexpr double repeats = 1e-9, nearly_repeats = 1e-5;

// Differences of periods by which the next one is guessed: two for a body that rings, one for each
// slow relaxation.
constexpr std::size_t guessed_by = 8;

// By so much more than the least a period may fail to repeat after a guess.
constexpr double most_worse = 4;

// Of sums in doubles.
constexpr double at_bound = 1e-9;

// Of cells, in a unit of effort: some operations on numbers that lie side by side.
constexpr std::size_t side_by_side = 8;

}  // namespace

HeldCells::HeldCells(const HalfSpace& half_space, const ScaledContact& contact,
                     const ScaledHolder& holder, int count, int steps)
    : holder_(holder),
      steps_(steps),
      body_((holder.mass > 0 ? 1 : 0) + 1 + static_cast<Eigen::Index>(holder.branches.size())),
      step_(two_pi / steps),
      // A body or a damper is balanced over the step; springs alone, which have no rate, at its
      // end.
      share_(holder.mass > 0 || holder.damper > 0 ? 0.5 : 1) {
  const MemoryCells cells(half_space);
  const simulation::ContactModes& modes = cells.modes();
  branches_ = static_cast<Eigen::Index>(modes.branch_rates.size());
  left_.resize(branches_);
  gained_.resize(branches_);
  double stiff = modes.damper / step_;
  const auto gain = [&](double rate) {
    return rate > 0 ? -std::expm1(-rate * step_) / (rate * step_) : 1;
  };
  for (Eigen::Index j = 0; j < branches_; ++j) {
    const auto i = static_cast<simulation::Index>(j);
    left_(j) = std::exp(-modes.branch_rates[i] * step_);
    gained_(j) = modes.branch_stiffness[i] * gain(modes.branch_rates[i]);
    stiff += gained_(j);
  }
  slope_ = 2 * holder.mass / (step_ * step_) + holder.damper / step_ + share_ * holder.spring;
  for (const MaxwellBranch& branch : holder.branches) {
    held_left_.push_back(std::exp(-step_ / branch.time));
    held_gained_.push_back(branch.stiffness * gain(1 / branch.time));
    slope_ += share_ * held_gained_.back();
  }
  place_cells(half_space, cells, contact.force_unit(), count);
  glassy_ = stiff * weights_;
}

void HeldCells::place_cells(const HalfSpace& half_space, const MemoryCells& cells, double unit,
                            int count) {
  const CellPanels panels(half_space);
  const int each =
      std::max<int>(1, count / static_cast<int>(panels.closed.size() + panels.opening.size()));
  count_ = each * static_cast<Eigen::Index>(panels.closed.size() + panels.opening.size());
  weights_.resize(count_);
  bounds_ = Eigen::MatrixXd::Zero(count_, steps_);
  // Of each step and of the same a period before, for all cells.
  std::vector<double> swings, earlier;
  for (int n = 1; n <= steps_; ++n) {
    swings.push_back(cells.swing_force(step_ * n));
    earlier.push_back(cells.swing_force(step_ * n - two_pi));
  }
  Eigen::Index i = 0;
  const auto place = [&](const Panel& panel, bool opens) {
    for (int k = 0; k < each; ++k, ++i) {
      const double s = (k + 0.5) / each, x = panel.at(s);
      const double width = 2 * (panel.at((k + 1.0) / each) - panel.at(k * 1.0 / each)) / unit;
      weights_(i) = width * half_space.amplitude();
      CellTouch touch{-two_pi, two_pi, {}};
      if (opens)
        touch = cells.touch(x);
      else
        touch.decays = {half_space.static_modulus() * half_space.depth(x)};
      for (Eigen::Index n = 0; n < steps_; ++n) {
        double t = step_ * static_cast<double>(n + 1);
        const bool over = t > touch.end;
        if (over) t -= two_pi;
        if (t < touch.begin || t > touch.end) continue;
        const double swing = (over ? earlier : swings)[static_cast<std::size_t>(n)];
        bounds_(i, n) = std::max(0.0, width * cells.force(touch, t, swing));
      }
    }
  };
  for (const Panel& panel : panels.closed) place(panel, false);
  for (const Panel& panel : panels.opening) place(panel, true);
  bound_ = bounds_.sum();
}

/// Of all cells after a way of theirs, and its slope. Which cells slide changes from cell to cell:
/// a choice of numbers is quicker than a jump that is guessed wrongly.
double HeldCells::pulled(const Eigen::ArrayXd& relaxed, Eigen::Index step, double way,
                         double& slope) const {
  const double* bounds = bounds_.col(step).data();
  slope = 0;
  double sum = 0;
  for (Eigen::Index i = 0; i < count_; ++i) {
    const double force = relaxed(i) + glassy_(i) * way, bound = bounds[i];
    sum += std::min(std::max(force, -bound), bound);
    slope += std::abs(force) < bound ? glassy_(i) : 0.0;
  }
  return sum;
}

// The body's numbers: by how much it is slower than the drive, if it has a mass; the forces of the
// drive's spring and branches. Then those of the cells' branches, one branch after the other.
HeldCells::Period HeldCells::period(StateVector& state, double velocity, Effort& effort) const {
  Period result;
  const Eigen::Index spring = holder_.mass > 0 ? 1 : 0;
  Eigen::Map<Eigen::ArrayXXd> forces(state.data() + body_, count_, branches_);
  Eigen::ArrayXd relaxed(count_), ways(count_);
  const double driven = velocity * step_;
  double friction = forces.sum();
  for (Eigen::Index n = 0; n < steps_; ++n) {
    effort.spend(static_cast<std::size_t>(count_ * (branches_ + 2)) / side_by_side);
    relaxed = left_(0) * forces.col(0);
    for (Eigen::Index j = 1; j < branches_; ++j) relaxed += left_(j) * forces.col(j);
    // slope d + rest = share times what cells pull, with the body's way d behind the drive.
    double rest = state(spring) - (1 - share_) * friction;
    if (holder_.mass > 0) rest -= 2 * holder_.mass / step_ * state(0);
    for (std::size_t j = 0; j < held_left_.size(); ++j)
      rest +=
          (1 - share_ + share_ * held_left_[j]) * state(spring + 1 + static_cast<Eigen::Index>(j));
    double d = 0, piece = -1;
    for (int i = 0; i < most_pieces; ++i) {
      double slope = 0;
      const double pull = pulled(relaxed, n, driven - d, slope);
      d -= (slope_ * d + rest - share_ * pull) / (slope_ + share_ * slope);
      if (slope == piece) break;  // the same straight piece as before, and so its root
      piece = slope;
    }
    if (holder_.mass > 0) state(0) = 2 * d / step_ - state(0);
    state(spring) += holder_.spring * d;
    for (std::size_t j = 0; j < held_left_.size(); ++j) {
      double& force = state(spring + 1 + static_cast<Eigen::Index>(j));
      force = held_left_[j] * force + held_gained_[j] * d;
    }
    friction = 0;
    const double* bounds = bounds_.col(n).data();
    for (Eigen::Index i = 0; i < count_; ++i) {
      const double bound = bounds[i], wanted = relaxed(i) + glassy_(i) * (driven - d);
      const double force = std::min(std::max(wanted, -bound), bound);
      if (wanted < -bound * (1 + at_bound) && bound > at_bound * weights_(i))
        result.backslip = true;
      ways(i) = (force - relaxed(i)) / glassy_(i);
      friction += force;
    }
    for (Eigen::Index j = 0; j < branches_; ++j)
      forces.col(j) = left_(j) * forces.col(j) + gained_(j) * weights_ * ways;
    result.friction += friction;
  }
  return result;
}

/// As it moves the friction: of all cells together.
double HeldCells::size(const StateVector& change) const {
  return std::max(change.head(body_).lpNorm<Eigen::Infinity>(),
                  change.tail(change.size() - body_).lpNorm<1>());
}

// Periods, each of which leads nearer to one that repeats; from a few of them Anderson's method
// guesses it, as what is left falls slowly where the body rings or cells relax slowly.
HeldCells::Steady HeldCells::steady(double velocity, double sliding, SharedEffort* whole) const {
  Effort effort(simulation::effort_of_state, whole);
  StateVector now = StateVector::Zero(body_ + count_ * branches_);
  if (holder_.spring > 0) now(holder_.mass > 0 ? 1 : 0) = bound_ / static_cast<double>(steps_);
  for (int i = 0; i < first_periods; ++i) period(now, std::max(velocity, sliding), effort);
  std::vector<StateVector> lacks, ends;
  StateVector best;
  double least = infinity;
  Steady result;
  for (int i = 0, plain = 0, left_plain = 0; i < most_marched; ++i) {
    StateVector end = now;
    const Period found = period(end, velocity, effort);
    const StateVector lack = end - now;
    const double size_of_lack = size(lack);
    if (size_of_lack > most_worse * least) {  // a guess that led away: some periods without one
      left_plain = ++plain;
      lacks.clear();
      ends.clear();
      now = best;
      least = infinity;
      continue;
    }
    if (size_of_lack <= least) {
      least = size_of_lack;
      best = end;
    }
    result = {found.friction / bound_, size_of_lack, found.backslip};
    lacks.push_back(lack);
    ends.push_back(end);
    if (lacks.size() > guessed_by) {
      lacks.erase(lacks.begin());
      ends.erase(ends.begin());
    }
    StateVector next = end;
    if (const auto n = static_cast<Eigen::Index>(lacks.size()) - 1; n > 0) {
      Eigen::MatrixXd of_lack(lack.size(), n), of_end(lack.size(), n);
      for (Eigen::Index j = 0; j < n; ++j) {
        const auto k = static_cast<std::size_t>(j);
        of_lack.col(j) = lacks[k + 1] - lacks[k];
        of_end.col(j) = ends[k + 1] - ends[k];
      }
      const StateVector guess = end - of_end * linear::PivotedQr(of_lack).solve(lack);
      result.open = std::max(result.open, size(guess - now));
      if (left_plain-- <= 0) next = guess;
    }
    if (result.open <= repeats && i > 0) return result;
    now = next;
  }
  if (result.open <= nearly_repeats) return result;
  throw ModelError(
      "below the indenter no steady motion is found: its body rings, or its cells creep for too "
      "many periods",
      "give a higher speed; vcrit eval gives the limit of friction at rest");
}

}  // namespace vcrit::indenter
