#include "realisation/causal_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/interruption.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Poles = std::vector<Complex>;

Index columns_of(const Poles& poles) {
  Index count = 0;
  for (const Complex& pole : poles) count += pole.imag() > 0 ? 2 : 1;
  return count;
}

// 1/(s - p) + its conjugate and i times their difference for a pair, so that the residues are real;
// each times |Re p|, as else columns of sharp resonances dwarf all others.
MatrixXcd partial_fractions(const Rows& rows, const Poles& poles) {
  MatrixXcd columns(rows.size(), columns_of(poles));
  Index column = 0;
  for (const Complex& pole : poles) {
    for (Index i = 0; i < rows.size(); ++i) {
      const Complex s(0, rows.omega[i]);
      const Complex up = -pole.real() / (s - pole), down = -pole.real() / (s - std::conj(pole));
      columns(i, column) = pole.imag() > 0 ? up + down : up;
      if (pole.imag() > 0) columns(i, column + 1) = Complex(0, 1) * (up - down);
    }
    column += pole.imag() > 0 ? 2 : 1;
  }
  return columns;
}

MatrixXd real_rows(const MatrixXcd& columns, const VectorXd& weight) {
  MatrixXd both(2 * columns.rows(), columns.cols());
  both << weight.asDiagonal() * columns.real(), weight.asDiagonal() * columns.imag();
  return both;
}

VectorXd scaled_solution(MatrixXd matrix, const VectorXd& right) {
  const VectorXd size =
      matrix.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
  matrix = matrix * size.cwiseInverse().asDiagonal();
  return linear::PivotedQr(matrix).solve(right).cwiseQuotient(size);
}

Poles start_poles(const Rows& rows, Index pairs, bool by_factor) {
  Poles poles;
  const double low = rows.first(), high = rows.last();
  for (Index k = 0; k < pairs; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(pairs);
    const double w = by_factor ? low * std::pow(high / low, share) : low + (high - low) * share;
    poles.emplace_back(-0.02 * w, w);
  }
  return poles;
}

// The zeros of sigma = d + sum c/(s - p): eigenvalues of A - b c^T/d.
Poles zeros_of(const Poles& poles, const VectorXd& residues, double constant) {
  const Index count = residues.size();
  MatrixXd a = MatrixXd::Zero(count, count);
  VectorXd b = VectorXd::Zero(count);
  Index place = 0;
  for (const Complex& pole : poles) {
    a(place, place) = pole.real();
    b[place] = -pole.real();
    if (pole.imag() > 0) {
      a(place + 1, place + 1) = pole.real();
      a(place, place + 1) = pole.imag();
      a(place + 1, place) = -pole.imag();
      b[place] *= 2;
    }
    place += pole.imag() > 0 ? 2 : 1;
  }
  a -= b * residues.transpose() / constant;
  if (!a.allFinite()) return poles;
  Poles zeros;
  for (const auto& zero : linear::eigenvalues(a.cast<long double>()))
    if (zero.imag() >= 0) zeros.emplace_back(zero);
  return zeros;
}

// Stable, and no faster, slower or sharper than rows could show.
void settle(const Rows& rows, Poles& poles) {
  for (Complex& pole : poles) {
    const double size = std::clamp(std::abs(pole), rows.first() * 1e-3, rows.last() * 1e3);
    if (pole.imag() < 1e-9 * std::abs(pole)) {
      pole = -size;
      continue;
    }
    const double angle = std::max(std::abs(pole.real()) / std::abs(pole), 1e-6);
    pole = size * Complex(-angle, std::sqrt(std::max(0.0, 1 - angle * angle)));
  }
}

Poles relocated(const Rows& rows, const Poles& poles) {
  const MatrixXcd fractions = partial_fractions(rows, poles);
  const Index count = fractions.cols();
  MatrixXcd columns(rows.size(), 2 * count + 2);
  columns.leftCols(count) = fractions;
  columns.col(count).setOnes();
  columns.middleCols(count + 1, count) = -(rows.value.asDiagonal() * fractions);
  columns.col(2 * count + 1) = -rows.value;
  MatrixXd matrix(2 * rows.size() + 1, columns.cols());
  matrix.topRows(2 * rows.size()) = real_rows(columns, rows.weight);
  // Sum of Re sigma = number of rows, of the weight of one row: no zero solution (relaxed).
  matrix.bottomRows(1).setZero();
  const auto number = static_cast<double>(rows.size());
  matrix.bottomRows(1).middleCols(count + 1, count) = fractions.real().colwise().sum() / number;
  matrix(2 * rows.size(), 2 * count + 1) = 1;
  VectorXd right = VectorXd::Zero(matrix.rows());
  right[2 * rows.size()] = 1;
  const VectorXd solution = scaled_solution(matrix, right);
  double constant = solution[2 * count + 1];
  // Below that sigma's zeros are far away or rounding (Gustavsen 2006).
  if (std::abs(constant) < 1e-8) constant = std::copysign(1e-8, constant);
  Poles next = zeros_of(poles, solution.segment(count + 1, count), constant);
  settle(rows, next);
  return next;
}

CausalFit with_residues(const Rows& rows, const Poles& poles, VectorXd* residues = nullptr) {
  const MatrixXcd fractions = partial_fractions(rows, poles);
  MatrixXcd columns(rows.size(), fractions.cols() + 1);
  columns << fractions, VectorXcd::Ones(rows.size());
  VectorXd right(2 * rows.size());
  right << rows.weight.cwiseProduct(rows.value.real()), rows.weight.cwiseProduct(rows.value.imag());
  const VectorXd found = scaled_solution(real_rows(columns, rows.weight), right);
  CausalFit fit{poles, {}, 0};
  // Rows of weight 0 are left out of the fit, and still have what is left of them.
  fit.left = (rows.value - columns * found)
                 .cwiseQuotient(rows.value.cwiseAbs().cwiseMax(std::numeric_limits<double>::min()));
  fit.sum = rows.weight.cwiseProduct(rows.value - columns * found).squaredNorm();
  if (residues) *residues = found;
  return fit;
}

double spacing_at(const Rows& rows, double omega) {
  const auto above = std::lower_bound(rows.omega.begin(), rows.omega.end(), omega);
  const auto place = std::clamp<std::ptrdiff_t>(above - rows.omega.begin(), 1, rows.size() - 1);
  return rows.omega[place] - rows.omega[place - 1];
}

Index rows_beyond(const VectorXcd& left, double level) {
  return (left.cwiseAbs().array() > level).count();
}

// A resonance narrower than the rows' distance is what one row at fault looks like, too. It is kept
// where it takes energy (a pair of residue r adds r/|Re p| to R at its peak: Im < 0) and where more
// rows than its nearest would miss it.
CausalFit without_doubtful_pairs(const Rows& rows, const CausalFit& fit) {
  constexpr Index nearest_rows = 5;
  VectorXd residues;
  with_residues(rows, fit.poles, &residues);
  const double level = std::max(5 * robust_noise(fit.left), 1e-4);
  Poles kept;
  Index place = 0;
  for (std::size_t i = 0; i < fit.poles.size(); ++i) {
    const Complex& pole = fit.poles[i];
    const bool pair = pole.imag() > 0;
    const bool narrow = pair && -pole.real() < 2 * spacing_at(rows, pole.imag()) &&
                        pole.imag() > rows.omega[0] && pole.imag() < rows.last();
    Poles others = fit.poles;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (!narrow || (residues[place + 1] < 0 &&
                    rows_beyond(with_residues(rows, others).left, level) > nearest_rows))
      kept.push_back(pole);
    place += pair ? 2 : 1;
  }
  return kept.size() == fit.poles.size() ? fit : with_residues(rows, kept);
}

double schwarz(double sum, Index numbers, Index parameters) {
  const auto n = static_cast<double>(numbers);
  return n * std::log(std::max(sum, 1e-28 * n) / n) + static_cast<double>(parameters) * std::log(n);
}

}  // namespace

CausalFit causal_fit(const Rows& rows, Index pairs, bool by_factor) {
  Poles poles = start_poles(rows, pairs, by_factor);
  CausalFit best = with_residues(rows, poles);
  constexpr int most_moves = 20;
  int idle = 0;
  for (int move = 0; move < most_moves && idle < 4; ++move) {
    hear_interruption();
    poles = relocated(rows, poles);
    CausalFit next = with_residues(rows, poles);
    idle = next.sum < 0.99 * best.sum ? 0 : idle + 1;
    if (next.sum < best.sum) best = std::move(next);
  }
  return best;
}

namespace {

CausalFit better_start(const Rows& rows, Index pairs) {
  CausalFit fit = causal_fit(rows, pairs, false), other = causal_fit(rows, pairs, true);
  return without_doubtful_pairs(rows, other.sum < fit.sum ? other : fit);
}

// Once more with rows that are off by more than noise counting less, as for least absolute values:
// else the fit bends towards them, and their neighbours seem to be at fault.
CausalFit with_rows_at_fault(const Rows& rows, Index pairs, CausalFit fit) {
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    const double level = 3 * std::max(robust_noise(fit.left), 1e-9);
    if (rows_beyond(fit.left, 2 * level) == 0) break;
    Rows weighed = rows;
    for (Index i = 0; i < rows.size(); ++i)
      weighed.weight[i] *=
          std::min(1.0, std::pow(level / std::max(std::abs(fit.left[i]), level), 2));
    fit = better_start(weighed, pairs);
  }
  return fit;
}

}  // namespace

CausalFit best_causal_fit(const Rows& all) {
  // These rows are enough to find the poles; the residuals are taken at all rows.
  constexpr Index most_rows = 500;
  const Rows rows = thinned(all, most_rows);
  // A pair has two poles and two residues: more pairs than that no row could contradict.
  const Index most = std::clamp<Index>((rows.size() - 2) / 4, 1, 12);
  CausalFit best;
  Index best_pairs = 1;
  double least = std::numeric_limits<double>::infinity();
  int idle = 0;
  for (Index pairs = 1; pairs <= most && idle < 3; ++pairs) {
    CausalFit fit = better_start(rows, pairs);
    const double criterion = schwarz(fit.sum, 2 * rows.size(), 2 * columns_of(fit.poles) + 1);
    idle = criterion < least ? 0 : idle + 1;
    if (criterion < least) least = criterion, best = std::move(fit), best_pairs = pairs;
  }
  best = with_rows_at_fault(rows, best_pairs, std::move(best));
  return rows.size() < all.size() ? with_residues(all, best.poles) : best;
}

double robust_noise(const VectorXcd& left) {
  std::vector<double> sizes;
  for (const Complex& each : left) sizes.push_back(std::abs(each));
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle / std::sqrt(2 * std::log(2.0));  // the median of Rayleigh's distribution
}

}  // namespace vcrit::realisation
