#include "modes/spectrum.hpp"

namespace vcrit::simulation {

namespace {

Integrals<PairNumber> unmoved(double q) { return {PairNumber{1, 0, q}, {0, 0, q}, {0, 0, q}}; }

}  // namespace

ModalFactors::ModalFactors(const Spectrum& spectrum, double duration) : duration_(duration) {
  if (duration == 0) {
    singles_.resize(spectrum.singles(), {1, 0, 0});
    for (const ModePair& pair : spectrum.pairs) pairs_.push_back(unmoved(pair.q));
    turn_ = unmoved(-1);
    return;
  }
  turn_ = turn_integrals(duration);
  for (const double rate : spectrum.rates) singles_.push_back(integrals(rate, duration));
  for (const ModePair& pair : spectrum.pairs)
    pairs_.push_back(integrals(pair.exponent, pair.receptance, pair.rate, duration));
}

ModalFactors::Passed ModalFactors::passed(ConstMatrixView z) const {
  const Index n = z.rows;
  Passed result(n, z.columns);
  for (Index j = 0; j < z.columns; ++j) {
    const double* from = z.column(j).data();
    double* to = result.numbers_.data() + 3 * n * j;
    for (const Integrals<double>& single : singles_) {
      for (Index k = 0; k < 3; ++k) to[k * n] = *from * single[k];
      ++from, ++to;
    }
    for (const Integrals<PairNumber>& pair : pairs_) {
      const PairNumber start{from[0], from[1], pair[0].q};
      for (Index k = 0; k < 3; ++k) {
        const PairNumber number = start * pair[k];
        to[k * n] = number.a, to[k * n + 1] = number.b;
      }
      from += 2, to += 2;
    }
  }
  return result;
}

Modes uncoupled(const Vector& rates) {
  return {{rates, {}}, identity(rates.size()), identity(rates.size())};
}

// Modes in the order singles of a, singles of b, pairs of a, pairs of b.
Modes beside(const Modes& a, const Modes& b) {
  const Index n = a.spectrum.size(), m = b.spectrum.size();
  const Index states = a.to_modes.columns(), others = b.to_modes.columns();
  Modes both{a.spectrum, Matrix(n + m, states + others), Matrix(states + others, n + m)};
  both.spectrum.rates.append(b.spectrum.rates.begin(), b.spectrum.rates.end());
  both.spectrum.pairs.insert(both.spectrum.pairs.end(), b.spectrum.pairs.begin(),
                             b.spectrum.pairs.end());
  const auto copy = [&](const Modes& one, Index state, const auto& place) {
    for (Index i = 0; i < one.spectrum.size(); ++i)
      for (Index j = 0; j < one.to_modes.columns(); ++j) {
        both.to_modes(place(i), state + j) = one.to_modes(i, j);
        both.from_modes(state + j, place(i)) = one.from_modes(j, i);
      }
  };
  const Index first = a.spectrum.singles(), second = b.spectrum.singles();
  copy(a, 0, [&](Index i) { return i < first ? i : i + second; });
  copy(b, states, [&](Index i) { return i < second ? first + i : n + i; });
  return both;
}

}  // namespace vcrit::simulation
