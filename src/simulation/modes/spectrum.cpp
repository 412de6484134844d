#include "simulation/modes/spectrum.hpp"

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

Integrals<PairNumber> unmoved(double q) { return {PairNumber{1, 0, q}, {0, 0, q}, {0, 0, q}}; }

}  // namespace

Factors::Factors(const Spectrum& spectrum, double duration) : duration_(duration) {
  if (duration == 0) {
    singles_.resize(spectrum.singles(), {1, 0, 0});
    if (spectrum.pair) pair_ = unmoved(spectrum.pair->q);
    turn_ = unmoved(-1);
    return;
  }
  turn_ = turn_integrals(duration);
  for (const double rate : spectrum.rates) singles_.push_back(integrals(rate, duration));
  if (const auto& pair = spectrum.pair)
    pair_ = integrals(pair->exponent, pair->receptance, pair->rate, duration);
}

Modes uncoupled(const Vector& rates) {
  return {{rates, {}}, identity(rates.size()), identity(rates.size())};
}

// The singles of b come between the singles and the pair of a.
Modes beside(const Modes& a, const Modes& b) {
  ensure(!b.spectrum.pair, "only one of two systems has a pair of modes");
  const Index n = a.spectrum.size(), m = b.spectrum.size(), singles = a.spectrum.singles();
  const Index states = a.to_modes.columns(), others = b.to_modes.columns();
  Modes both{a.spectrum, Matrix(n + m, states + others), Matrix(states + others, n + m)};
  both.spectrum.rates.insert(both.spectrum.rates.end(), b.spectrum.rates.begin(),
                             b.spectrum.rates.end());
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < states; ++j) {
      const Index mode = i < singles ? i : i + m;
      both.to_modes(mode, j) = a.to_modes(i, j);
      both.from_modes(j, mode) = a.from_modes(j, i);
    }
  for (Index i = 0; i < m; ++i)
    for (Index j = 0; j < others; ++j) {
      both.to_modes(singles + i, states + j) = b.to_modes(i, j);
      both.from_modes(states + j, singles + i) = b.from_modes(j, i);
    }
  return both;
}

}  // namespace vcrit::simulation
