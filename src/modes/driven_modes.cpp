#include "modes/driven_modes.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "modes/beyond_doubles.hpp"

namespace vcrit::simulation {

namespace {

// Rates that differ by less than this share of their sum are a pair: the coefficients of separate
// modes would grow like the share's inverse.
constexpr double close_rates = 0.1;

// A pair of modes nearer than this to a rate would need three modes to belong together.
constexpr double least_distance = 1e-4;

// One row of `to` for each mode, one column of `from`, in the order in which they are found.
class Driven {
 public:
  Driven(const Modes& own, ConstView direction, const Vector& rates)
      : own_(own), rates_(rates), states_(own.to_modes.columns()), push_(own.to_modes.rows()) {
    add_product(own.to_modes, direction, push_);
    for (Index i = 0; i < rates.size(); ++i) load(i);
    for (Index k = 0; k < own.spectrum.singles(); ++k) single(k);
    for (Index p = 0; p < own.spectrum.pairs.size(); ++p) pair(p);
  }

  Modes modes() && {
    const Index singles = singles_.size(), n = singles + pairs_.size(), states = row();
    Modes result{{}, Matrix(n, states), Matrix(states, n)};
    const auto put = [&](const Mode& mode, Index at) {
      for (Index j = 0; j < states; ++j) {
        result.to_modes(at, j) = mode.to[j];
        result.from_modes(j, at) = mode.from[j];
      }
    };
    for (Index i = 0; i < singles; ++i) put(singles_[i], i);
    for (Index i = 0; i < pairs_.size(); ++i) put(pairs_[i], singles + i);
    result.spectrum = std::move(spectrum_);
    return result;
  }

 private:
  struct Mode {
    Vector to, from;
  };

  Index row() const { return states_ + rates_.size(); }
  Mode mode() const { return {Vector(row()), Vector(row())}; }

  // Each q_i is a mode of its own.
  void load(Index i) {
    Mode own = mode();
    own.to[states_ + i] = own.from[states_ + i] = 1;
    add_single(rates_[i], own);
  }

  void add_single(double rate, Mode mode) {
    spectrum_.rates.push_back(rate);
    singles_.push_back(std::move(mode));
  }

  // z' = -rate z - d sum_i a_i q_i, with d the push. Of a rate a that is not near, y takes up
  // -gamma q with gamma = d a/(rate - a).
  void single(Index k) {
    const double rate = own_.spectrum.rates[k];
    Mode alone = mode();
    List<Index> moving;  // one of many, where the mode is of a network
    for (Index j = 0; j < states_; ++j) {
      alone.to[j] = own_.to_modes(k, j);
      alone.from[j] = own_.from_modes(j, k);
      if (alone.from[j] != 0) moving.push_back(j);
    }
    List<Index, 2> near;
    for (Index i = 0; i < rates_.size() && push_[k] != 0; ++i) {
      if (std::abs(rate - rates_[i]) < close_rates * (rate + rates_[i])) {
        near.push_back(i);
        continue;
      }
      const double share = push_[k] * rates_[i] / (rate - rates_[i]);
      alone.to[states_ + i] = share;
      for (const Index j : moving) singles_[i].from[j] -= share * alone.from[j];
    }
    if (near.empty()) return add_single(rate, std::move(alone));
    for (const Index i : near) {
      join(rate, i, push_[k], alone);
      alone.to = Vector(row());  // what z starts with is in the first of them
    }
  }

  // With p, delta = (rate +- a)/2 the amplitude is -delta z - d a q + z sigma: its sigma part is z.
  void join(double rate, Index i, double push, const Mode& alone) {
    const double half = 0.5 * (rate - rates_[i]);
    spectrum_.pairs.emplace_back(0.5 * (rate + rates_[i]), half * half);
    Mode real = mode(), sigma = alone;
    for (Index j = 0; j < row(); ++j) real.to[j] = -half * alone.to[j];
    real.to[states_ + i] -= push * rates_[i];
    pairs_.push_back(std::move(real));
    pairs_.push_back(std::move(sigma));
  }

  // The same in the pair's own numbers, gamma = -d a/(s + a).
  void pair(Index p) {
    const Index at = own_.spectrum.place(p);
    const ModePair& modes = own_.spectrum.pairs[p];
    Mode real = mode(), sigma = mode();
    for (Index j = 0; j < states_; ++j) {
      real.to[j] = own_.to_modes(at, j);
      sigma.to[j] = own_.to_modes(at + 1, j);
      real.from[j] = own_.from_modes(j, at);
      sigma.from[j] = own_.from_modes(j, at + 1);
    }
    const PairNumber push{push_[at], push_[at + 1], modes.q};
    for (Index i = 0; i < rates_.size(); ++i) {
      const PairNumber distance = modes.exponent + rates_[i];
      const double norm = std::abs(distance.a * distance.a - modes.q);
      require_doubles(!std::isnan(norm));
      if (!(norm > least_distance * least_distance * rates_[i] * rates_[i]))
        throw ModelError(
            "the normal network relaxes as fast as the critically damped body on its drive");
      const PairNumber share = push * inverse(distance) * -rates_[i];
      real.to[states_ + i] = share.a;
      sigma.to[states_ + i] = share.b;
      for (Index j = 0; j < states_; ++j)
        singles_[i].from[j] -= share.a * real.from[j] + share.b * sigma.from[j];
    }
    spectrum_.pairs.push_back(modes);
    pairs_.push_back(std::move(real));
    pairs_.push_back(std::move(sigma));
  }

  const Modes& own_;
  const Vector& rates_;
  Index states_;
  Vector push_;
  Spectrum spectrum_;
  std::vector<Mode> singles_, pairs_;
};

}  // namespace

Modes driven(const Modes& own, ConstView direction, const Vector& rates) {
  return Driven(own, direction, rates).modes();
}

}  // namespace vcrit::simulation
