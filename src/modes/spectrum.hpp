// Modes of linear motion: real decay rates, and pairs of modes that belong together (see
// pair_number.hpp). A body held by springs and dampers has no more than one pair of its own.
#pragma once

#include <vector>

#include "modes/exponentials.hpp"
#include "modes/storage.hpp"

namespace vcrit::simulation {

/// s = -decay +- sqrt(q).
struct ModePair {
  ModePair(double of_decay, double of_q)
      : decay(of_decay),
        q(of_q),
        exponent{-decay, 1, q},
        receptance(inverse(exponent)),
        rate(magnitude(exponent)) {}

  double decay, q;
  PairNumber exponent, receptance;  ///< s, 1/s
  double rate;                      ///< |s|, of two real ones the larger
};

/// Modal coordinates: one a single mode, amplitude of e^{-rate t}; then, for each pair, the parts
/// a, b of its amplitude a + b sigma. A pair's contribution to an output is the sigma part of
/// weight * amplitude * e^{(-decay + sigma) t}, so a row of coefficients (x, y) on (a, b) is the
/// weight y + x sigma.
struct Spectrum {
  Vector rates;
  List<ModePair, usual_pairs> pairs;

  Index singles() const { return rates.size(); }
  Index size() const { return singles() + 2 * pairs.size(); }
  Index place(Index pair) const { return singles() + 2 * pair; }  ///< of its coordinates
  PairNumber amplitude(ConstView z, Index pair) const {
    return {z[place(pair)], z[place(pair) + 1], pairs[pair].q};
  }
  PairNumber weight(ConstView row, Index pair) const {
    return {row[place(pair) + 1], row[place(pair)], pairs[pair].q};
  }
};

/// What a spectrum and the oscillation do over one duration.
class ModalFactors {
 public:
  ModalFactors() = default;
  ModalFactors(const Spectrum& spectrum, double duration);

  double duration() const { return duration_; }
  const Integrals<double>& single(Index i) const { return singles_[i]; }
  const Integrals<PairNumber>& pair(Index i) const { return pairs_[i]; }
  const Integrals<PairNumber>& turn() const { return turn_; }

  /// For each modal coordinate and its integrals: use(i, {z_i, once, twice}) after the duration.
  template <class Use>
  void apply(ConstView z, const Use& use) const {
    const Index n = singles_.size();
    for (Index i = 0; i < n; ++i)
      use(i,
          Integrals<double>{z[i] * singles_[i][0], z[i] * singles_[i][1], z[i] * singles_[i][2]});
    const auto apply_pair = [&](Index i, const Integrals<PairNumber>& pair) {
      const PairNumber start{z[i], z[i + 1], pair[0].q};
      const PairNumber none = start * pair[0], once = start * pair[1], twice = start * pair[2];
      use(i, Integrals<double>{none.a, once.a, twice.a});
      use(i + 1, Integrals<double>{none.b, once.b, twice.b});
    };
    // Most have one, or none: taken for itself, it costs a tenth less than in the loop.
    if (pairs_.empty()) return;
    apply_pair(n, pairs_.front());
    for (Index p = 1; p < pairs_.size(); ++p) [[unlikely]] apply_pair(n + 2 * p, pairs_[p]);
  }

  /// The same of many at once, column by column: after the duration, and integrated over it once
  /// and twice.
  class Passed {
   public:
    Passed(Index rows, Index columns)
        : rows_(rows),
          columns_(columns),
          numbers_(3 * rows * columns, boost::container::default_init) {}

    ConstMatrixView now() const { return times(0); }
    ConstMatrixView once() const { return times(1); }
    ConstMatrixView twice() const { return times(2); }

   private:
    friend ModalFactors;
    ConstMatrixView times(Index integrals) const {
      return {numbers_.data() + integrals * rows_, rows_, columns_, 3 * rows_};
    }

    Index rows_, columns_;
    List<double, 3 * usual_states * usual_states> numbers_;
  };
  Passed passed(ConstMatrixView z) const;

 private:
  double duration_ = 0;
  List<Integrals<double>> singles_;
  List<Integrals<PairNumber>, usual_pairs> pairs_;
  Integrals<PairNumber> turn_;
};

/// Modes with the way to them and back: z = to_modes y, y = from_modes z.
struct Modes {
  Spectrum spectrum;
  Matrix to_modes;
  Matrix from_modes;
};

/// Both systems beside each other, y = (y_a, y_b).
Modes beside(const Modes& a, const Modes& b);

/// Modes that are the states themselves: y_i' = -rate_i y_i.
Modes uncoupled(const Vector& rates);

}  // namespace vcrit::simulation
