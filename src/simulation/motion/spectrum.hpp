// Modes of linear motion: real decay rates, and at most one pair of modes that belong together
// (see pair_number.hpp). A body held by springs and dampers has no more than one.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "simulation/motion/pair_number.hpp"
#include "simulation/motion/phi.hpp"

namespace vcrit::simulation {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

/// s = -decay +- sqrt(q).
struct ModePair {
  double decay = 0;
  double q = 0;
  PairNumber exponent() const { return {-decay, 1, q}; }
};

/// Modal coordinates: one a single mode, amplitude of e^{-rate t}; then, with a pair, the parts a,
/// b of its amplitude a + b sigma. A pair's contribution to an output is the sigma part of weight *
/// amplitude * e^{(-decay + sigma) t}, so a row of coefficients (x, y) on (a, b) is the weight y +
/// x sigma.
struct Spectrum {
  std::vector<double> rates;
  std::optional<ModePair> pair;

  Index singles() const { return static_cast<Index>(rates.size()); }
  Index size() const { return singles() + (pair ? 2 : 0); }
  PairNumber amplitude(const Vector& z) const { return {z(singles()), z(singles() + 1), pair->q}; }
  PairNumber weight(const Vector& row) const {
    return {row(singles() + 1), row(singles()), pair->q};
  }

  /// For each column z: the integral of row * z(x) * e^{-rate (t - x)} over x from 0 to t.
  Eigen::RowVectorXd filtered(const Vector& row, const Matrix& z, double rate, double t) const;

  /// The k-fold integral over the time t of each column of modal coordinates.
  template <class Coordinates>
  Coordinates integrated(int k, double t, Coordinates z) const {
    for (Index i = 0; i < singles(); ++i)
      z.row(i) *= integral(k, -rates[static_cast<std::size_t>(i)], t);
    if (!pair) return z;
    const PairNumber factor = integral(k, pair->exponent(), t);
    for (Index column = 0; column < z.cols(); ++column) {
      const PairNumber moved =
          PairNumber{z(singles(), column), z(singles() + 1, column), pair->q} * factor;
      z(singles(), column) = moved.a;
      z(singles() + 1, column) = moved.b;
    }
    return z;
  }
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
Modes uncoupled(const std::vector<double>& rates);

}  // namespace vcrit::simulation
