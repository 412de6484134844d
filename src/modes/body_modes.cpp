#include "modes/body_modes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/errors.hpp"
#include "modes/beyond_doubles.hpp"

namespace vcrit::simulation {

namespace {

// Two real rates closer than this share of their distances from the nearest pole, with no pole
// between them, are a pair: the coefficients of separate modes would grow like the share's inverse.
constexpr double close_roots = 0.1;

class BodyModes {
 public:
  BodyModes(double mass, const PoleSum& holder)
      : mass_(mass),
        holder_(holder),
        roots_(positive_roots({mass, holder.direct, holder.rates, holder.weights})) {
    if (roots_.size() + 1 == holder_.rates.size()) {
      first_guess();
      polish();
    } else {
      // A body has one mode more than its network.
      require_doubles(roots_.size() == holder_.rates.size() + 1);
      join_close_roots();
    }
  }

  Modes modes() const {
    Modes result;
    for (const OffsetRate& root : roots_) result.spectrum.rates.push_back(root.value());
    if (pair_) result.spectrum.pairs.emplace_back(pair_->decay.value(), pair_->q);
    const Index n = result.spectrum.size();
    result.to_modes = result.from_modes = Matrix(n, n);
    for (Index i = 0; i < result.spectrum.singles(); ++i) single(result, i);
    if (pair_) both(result);
    return result;
  }

 private:
  std::size_t poles() const { return holder_.rates.size(); }

  // Mode shape (1, k_j/(s + a_j)); its dual (m, -1/(s + a_j)), divided by chi'(s).
  void single(Modes& modes, Index i) const {
    const OffsetRate& root = roots_[i];
    double slope = mass_;
    modes.from_modes(0, i) = 1;
    modes.to_modes(i, 0) = mass_;
    for (std::size_t j = 0; j < poles(); ++j) {
      const double distance = -root.minus(holder_.rates[j]);
      modes.from_modes(j + 1, i) = holder_.weights[j] / distance;
      modes.to_modes(i, j + 1) = -1 / distance;
      slope -= holder_.weights[j] / distance / distance;
    }
    for (Index j = 0; j <= poles(); ++j) modes.to_modes(i, j) /= slope;
  }

  // The same for the pair, in its own numbers: amplitude = (m a - sum_j h_j/(s + a_j))/rho(s) with
  // chi = ((s + p)^2 - q) rho, outputs its sigma part.
  void both(Modes& modes) const {
    const Index n = modes.spectrum.singles();
    const PairNumber share = inverse(remaining_factor());
    const auto set = [&](Index state, PairNumber to, PairNumber from) {
      modes.to_modes(n, state) = to.a;
      modes.to_modes(n + 1, state) = to.b;
      modes.from_modes(state, n) = from.b;
      modes.from_modes(state, n + 1) = from.a;
    };
    set(0, share * mass_, PairNumber{1, 0, pair_->q});
    for (std::size_t j = 0; j < poles(); ++j) {
      const PairNumber receptance = inverse(above(holder_.rates[j]));
      set(j + 1, share * receptance * -1.0, receptance * holder_.weights[j]);
    }
  }

  // rho(s) = m prod_l (s + x_l)/prod_j (s + a_j) at the pair; factors alternate to stay in range.
  PairNumber remaining_factor() const {
    PairNumber rho{mass_, 0, pair_->q};
    for (std::size_t i = 0; i < std::max(roots_.size(), poles()); ++i) {
      if (i < roots_.size()) rho = rho * PairNumber{roots_[i].minus(pair_->decay), 1, pair_->q};
      if (i < poles()) rho = rho / (above(holder_.rates[i]));
    }
    return rho;
  }

  PairNumber characteristic() const {
    PairNumber sum = PairNumber{-pair_->decay.value(), 1, pair_->q} * mass_ + holder_.direct;
    for (std::size_t j = 0; j < poles(); ++j)
      sum = sum + inverse(above(holder_.rates[j])) * holder_.weights[j];
    return sum;
  }

  // Bairstow's iteration: chi/rho = 2 dp sigma - dq. Well conditioned also where both modes meet,
  // and a weak damping keeps its relative accuracy. It converges quadratically.
  void polish() {
    for (int i = 0; i < 12; ++i) {
      const PairNumber step = characteristic() / remaining_factor();
      const double decay = pair_->decay.value(), size = decay * decay + std::abs(pair_->q);
      pair_->decay.offset += step.b / 2;
      pair_->q -= step.a;
      if (std::abs(step.a) <= 4e-16 * size && std::abs(step.b) <= 4e-16 * decay) break;
    }
  }

  // Product and sum of the two missing roots, from Vieta's formulas at the fast or at the slow end,
  // whichever cancels less.
  void first_guess() {
    const bool held = holder_.rates.front() == 0;
    const std::size_t first = held ? 1 : 0;
    double linear = holder_.direct, inertia = mass_, fast = holder_.direct / mass_, slow = 0;
    double fast_size = fast, slow_size = 0;
    for (std::size_t j = first; j < poles(); ++j) {
      linear += holder_.weights[j] / holder_.rates[j];
      inertia -= holder_.weights[j] / holder_.rates[j] / holder_.rates[j];
      fast += holder_.rates[j];
      slow += 1 / holder_.rates[j];
    }
    slow += held ? linear / holder_.weights[0] : inertia / linear;
    fast_size = fast;
    slow_size = std::abs(slow);
    double product = (held ? holder_.weights[0] : linear) / mass_;
    for (std::size_t j = first; j < poles(); ++j) {
      product *= holder_.rates[j];
      if (j - first < roots_.size()) product /= roots_[j - first].value();
    }
    for (const OffsetRate& root : roots_) {
      fast -= root.value();
      slow -= 1 / root.value();
    }
    const bool fast_end = std::abs(fast) * slow_size >= std::abs(slow) * fast_size;
    const double decay = std::max(0.0, 0.5 * (fast_end ? fast : slow * product));
    pair_ = Pair{near_pole(decay), decay * decay - product};
  }

  OffsetRate near_pole(double rate) const {
    double reference = 0;
    for (const double pole : holder_.rates)
      if (std::abs(rate - pole) < std::abs(rate - reference)) reference = pole;
    return {reference, rate - reference};
  }

  bool pole_between(const OffsetRate& low, const OffsetRate& high) const {
    return std::any_of(holder_.rates.begin(), holder_.rates.end(),
                       [&](double pole) { return low.minus(pole) < 0 && high.minus(pole) > 0; });
  }

  void join_close_roots() {
    std::size_t best = roots_.size();
    double least = close_roots;
    for (std::size_t i = 0; i + 1 < roots_.size(); ++i) {
      const OffsetRate &low = roots_[i], &high = roots_[i + 1];
      const double share = high.minus(low) / (std::abs(low.offset) + std::abs(high.offset));
      if (share < least && !pole_between(low, high)) {
        least = share;
        best = i;
      }
    }
    if (best == roots_.size()) return;
    const double half = 0.5 * roots_[best + 1].minus(roots_[best]);
    pair_ = Pair{{roots_[best].reference, roots_[best].offset + half}, half * half};
    roots_.erase(roots_.begin() + static_cast<std::ptrdiff_t>(best),
                 roots_.begin() + static_cast<std::ptrdiff_t>(best) + 2);
    polish();
  }

  // s = -decay +- sqrt(q), the decay as an offset from the nearest pole like the single roots.
  struct Pair {
    OffsetRate decay;
    double q;
  };

  // s + rate at the pair.
  PairNumber above(double rate) const { return {-pair_->decay.minus(rate), 1, pair_->q}; }

  double mass_;
  const PoleSum& holder_;
  std::vector<OffsetRate> roots_;
  std::optional<Pair> pair_;
};

}  // namespace

Modes body_modes(double mass, const PoleSum& holder) { return BodyModes(mass, holder).modes(); }

}  // namespace vcrit::simulation
