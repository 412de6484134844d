#include "simulation/motion/spectrum.hpp"

#include "base/errors.hpp"

namespace vcrit::simulation {

Modes uncoupled(const std::vector<double>& rates) {
  const auto n = static_cast<Index>(rates.size());
  return {{rates, {}}, Matrix::Identity(n, n), Matrix::Identity(n, n)};
}

Eigen::RowVectorXd Spectrum::filtered(const Vector& row, const Matrix& z, double rate,
                                      double t) const {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(z.cols());
  for (Index i = 0; i < singles(); ++i)
    sum += row(i) * convolution(-rates[static_cast<std::size_t>(i)], -rate, t) * z.row(i);
  if (!pair) return sum;
  const PairNumber factor = weight(row) * convolution(pair->exponent(), -rate, t);
  return sum + factor.a * z.row(singles() + 1) + factor.b * z.row(singles());
}

// The singles of b come between the singles and the pair of a.
Modes beside(const Modes& a, const Modes& b) {
  ensure(!b.spectrum.pair, "only one of two systems has a pair of modes");
  const Index n = a.spectrum.size(), singles = a.spectrum.singles(), m = b.spectrum.size();
  const Index rest = n - singles, states = a.to_modes.cols();
  Modes both{a.spectrum, Matrix::Zero(n + m, states + b.to_modes.cols()),
             Matrix::Zero(states + b.to_modes.cols(), n + m)};
  both.spectrum.rates.insert(both.spectrum.rates.end(), b.spectrum.rates.begin(),
                             b.spectrum.rates.end());
  both.to_modes.topLeftCorner(singles, states) = a.to_modes.topRows(singles);
  both.to_modes.bottomLeftCorner(rest, states) = a.to_modes.bottomRows(rest);
  both.to_modes.block(singles, states, m, b.to_modes.cols()) = b.to_modes;
  both.from_modes.topLeftCorner(states, singles) = a.from_modes.leftCols(singles);
  both.from_modes.topRightCorner(states, rest) = a.from_modes.rightCols(rest);
  both.from_modes.block(states, singles, b.to_modes.cols(), m) = b.from_modes;
  return both;
}

}  // namespace vcrit::simulation
