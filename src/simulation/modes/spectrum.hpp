// Modes of linear motion: real decay rates, and at most one pair of modes that belong together
// (see pair_number.hpp). A body held by springs and dampers has no more than one.
#pragma once

#include <optional>
#include <vector>

#include "simulation/modes/exponentials.hpp"
#include "simulation/modes/storage.hpp"

namespace vcrit::simulation {

/// s = -decay +- sqrt(q).
struct ModePair {
  ModePair(double of_decay, double of_q)
      : decay(of_decay),
        q(of_q),
        exponent{-decay, 1, q},
        receptance(inverse(exponent)),
        rate(size(exponent)) {}

  double decay, q;
  PairNumber exponent, receptance;  ///< s, 1/s
  double rate;                      ///< |s|, of two real ones the larger
};

/// Modal coordinates: one a single mode, amplitude of e^{-rate t}; then, with a pair, the parts a,
/// b of its amplitude a + b sigma. A pair's contribution to an output is the sigma part of weight *
/// amplitude * e^{(-decay + sigma) t}, so a row of coefficients (x, y) on (a, b) is the weight y +
/// x sigma.
struct Spectrum {
  Vector rates;
  std::optional<ModePair> pair;

  Index singles() const { return rates.size(); }
  Index size() const { return singles() + (pair ? 2 : 0); }
  PairNumber amplitude(ConstView z) const { return {z[singles()], z[singles() + 1], pair->q}; }
  PairNumber weight(ConstView row) const { return {row[singles() + 1], row[singles()], pair->q}; }
};

/// What a spectrum and the oscillation do over one duration.
class Factors {
 public:
  Factors() = default;
  Factors(const Spectrum& spectrum, double duration);

  double duration() const { return duration_; }
  const Integrals<double>& single(Index i) const { return singles_[i]; }
  const Integrals<PairNumber>& pair() const { return pair_; }
  const Integrals<PairNumber>& turn() const { return turn_; }

  /// For each modal coordinate and its integrals: use(i, {z_i, once, twice}) after the duration.
  template <class Use>
  void apply(ConstView z, const Use& use) const {
    const Index n = singles_.size();
    for (Index i = 0; i < n; ++i)
      use(i,
          Integrals<double>{z[i] * singles_[i][0], z[i] * singles_[i][1], z[i] * singles_[i][2]});
    if (z.size() == n) return;
    const PairNumber start{z[n], z[n + 1], pair_[0].q};
    const PairNumber none = start * pair_[0], once = start * pair_[1], twice = start * pair_[2];
    use(n, Integrals<double>{none.a, once.a, twice.a});
    use(n + 1, Integrals<double>{none.b, once.b, twice.b});
  }

 private:
  double duration_ = 0;
  List<Integrals<double>> singles_;
  Integrals<PairNumber> pair_, turn_;
};

/// Modes with the way to them and back: z = to_modes y, y = from_modes z.
struct Modes {
  Spectrum spectrum;
  Matrix to_modes;
  Matrix from_modes;
};

/// Both systems beside each other, y = (y_a, y_b). Only `a` may have a pair.
Modes beside(const Modes& a, const Modes& b);

/// Modes that are the states themselves: y_i' = -rate_i y_i.
Modes uncoupled(const Vector& rates);

}  // namespace vcrit::simulation
