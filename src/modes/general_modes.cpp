#include "modes/general_modes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "linear/elimination.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::simulation {

namespace {

using WideReal = long double;
using WideMatrix = linear::Matrix<WideReal>;
using WideColumn = linear::Vector<WideReal>;

// Of the norm of A: what is left of a rate that is 0, of some dozen modes.
constexpr WideReal no_rate = 2e-18L;

// Two modes whose distance is less than this share of their size are found as a plane: each alone
// would lose as many digits. Farther apart they lose one at most.
constexpr WideReal close_modes = 0.1L;

// Beyond this amplification, more than a third of a double's digits, merging modes are kept apart.
// A change d of A moves k modes that merge apart by d^(1/k), and their numbers lose a rounding over
// the (k-1)-th power of that: for two and for three of them this change is about as large as that.
constexpr double worst_amplification = 1e5;
constexpr WideReal small_change = 2e-11L;

WideMatrix wide_matrix(const Dense<long double>& a) {
  WideMatrix result(static_cast<Eigen::Index>(a.rows()), static_cast<Eigen::Index>(a.columns()));
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = a(i, j);
  return result;
}

class Decomposition {
 public:
  explicit Decomposition(const WideMatrix& a)
      : a_(a), size_(a.norm()), eigen_(linear::general_eigen(a)) {
    if (!eigen_.converged)
      throw ModelError("the free motions of the drive with its masses do not converge");
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      const std::complex<WideReal> s = eigen_.values[i];
      if (s.imag() == 0)
        real_.push_back(i);
      else if (s.imag() > 0)
        add_pair_of(i);
    }
    std::ranges::sort(real_, {}, [&](Eigen::Index i) { return -eigen_.values[i].real(); });
    join_close();
    for (const Eigen::Index i : real_) add_single(i);
  }

  GeneralModes modes() const {
    const Eigen::Index n = a_.rows();
    WideMatrix from(n, n);
    Eigen::Index column = 0;
    GeneralModes result;
    for (const auto& [rate, shape] : singles_) {
      result.modes.spectrum.rates.push_back(static_cast<double>(rate));
      from.col(column++) = shape;
    }
    for (const Plane& plane : planes_) {
      result.modes.spectrum.pairs.emplace_back(static_cast<double>(plane.decay),
                                               static_cast<double>(plane.q));
      from.col(column++) = plane.a;
      from.col(column++) = plane.b;
    }
    const WideMatrix to = linear::Lu<WideReal>(from).inverse();
    const auto size = static_cast<Index>(n);
    result.modes.to_modes = result.modes.from_modes = Matrix(size, size);
    for (Index i = 0; i < size; ++i)
      for (Index j = 0; j < size; ++j) {
        const auto row = static_cast<Eigen::Index>(i), other = static_cast<Eigen::Index>(j);
        result.modes.to_modes(i, j) = static_cast<double>(to(row, other));
        result.modes.from_modes(i, j) = static_cast<double>(from(row, other));
      }
    result.amplification = static_cast<double>((from.cwiseAbs() * to.cwiseAbs()).maxCoeff());
    return result;
  }

 private:
  struct Plane {
    WideReal decay, q;
    WideColumn a, b;
  };

  // What is below 0, or as small as rounding, is none.
  WideReal decaying(WideReal rate) const { return rate > no_rate * size_ ? rate : 0; }

  void add_single(Eigen::Index i) {
    const WideColumn shape = eigen_.vectors.col(i).real();
    singles_.emplace_back(decaying(-eigen_.values[i].real()), shape / shape.norm());
  }

  void add_pair_of(Eigen::Index i) {
    const std::complex<WideReal> s = eigen_.values[i];
    if (s.imag() < close_modes * std::abs(s) && add_plane(-s.real(), -s.imag() * s.imag())) return;
    const WideColumn real = eigen_.vectors.col(i).real(), imaginary = eigen_.vectors.col(i).imag();
    planes_.push_back({decaying(-s.real()), -s.imag() * s.imag(), imaginary / s.imag(), real});
  }

  void join_close() {
    for (std::size_t i = 0; i + 1 < real_.size();) {
      const WideReal slow = -eigen_.values[real_[i]].real(),
                     fast = -eigen_.values[real_[i + 1]].real();
      if (!(fast - slow < close_modes * (slow + fast)) ||
          !add_plane((slow + fast) / 2, (fast - slow) * (fast - slow) / 4)) {
        ++i;
        continue;
      }
      real_.erase(real_.begin() + static_cast<std::ptrdiff_t>(i),
                  real_.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    }
  }

  // The plane on which (A + decay)^2 - q vanishes, by inverse iteration; it gives both numbers
  // better than the eigenvalues, which lose half of their digits where they meet. Nothing where
  // both modes are independent of each other at one rate.
  bool add_plane(WideReal decay, WideReal q) {
    const Eigen::Index n = a_.rows();
    const WideMatrix identity = WideMatrix::Identity(n, n), shifted = a_ + decay * identity;
    WideMatrix square = shifted * shifted - q * identity;
    square += 1e-19L * size_ * size_ * identity;
    const linear::Lu<WideReal> solver(square);
    WideMatrix plane(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      plane(i, 0) = std::cos(static_cast<WideReal>(i + 1));
      plane(i, 1) = std::sin(static_cast<WideReal>(2 * i + 1));
    }
    for (int i = 0; i < 4; ++i) {
      plane = solver.solve(plane);
      plane.col(0) /= plane.col(0).norm();
      for (int k = 0; k < 2; ++k) plane.col(1) -= plane.col(0) * plane.col(0).dot(plane.col(1));
      plane.col(1) /= plane.col(1).norm();
    }
    Eigen::Matrix<WideReal, 2, 2> inside = plane.transpose() * a_ * plane;
    const WideReal mean = inside.trace() / 2;
    inside -= mean * Eigen::Matrix<WideReal, 2, 2>::Identity();
    if (inside.norm() <= 1e-12L * std::abs(mean)) return false;
    const WideReal exact = inside(0, 0) * inside(0, 0) + inside(0, 1) * inside(1, 0);
    Eigen::Matrix<WideReal, 2, 1> best;
    WideReal widest = -1;
    for (const auto& [x, y] : {std::pair{1.0L, 0.0L}, {0.0L, 1.0L}, {0.6L, 0.8L}}) {
      const Eigen::Matrix<WideReal, 2, 1> one(x, y), other = inside * one;
      const WideReal area = std::abs(one[0] * other[1] - one[1] * other[0]);
      if (area > widest) widest = area, best = one;
    }
    planes_.push_back({decaying(-mean), exact, plane * best, plane * (inside * best)});
    return true;
  }

  WideMatrix a_;
  WideReal size_;
  linear::GeneralEigen<WideReal> eigen_;
  std::vector<Eigen::Index> real_;
  std::vector<std::pair<WideReal, WideColumn>> singles_;
  std::vector<Plane> planes_;
};

// Each entry by another part of up to this share of the norm, the same every time.
WideMatrix changed(WideMatrix a, WideReal share) {
  const WideReal size = share * a.norm();
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      a(i, j) += size * std::cos(static_cast<WideReal>(3 * i + 7 * j + 1));
  return a;
}

}  // namespace

GeneralModes general_modes(const Dense<long double>& a) {
  const WideMatrix exact = wide_matrix(a);
  GeneralModes found = Decomposition(exact).modes();
  if (found.amplification < worst_amplification) return found;
  GeneralModes apart = Decomposition(changed(exact, small_change)).modes();
  apart.change = static_cast<double>(small_change);
  const auto error = [](const GeneralModes& each) {
    return each.change + epsilon * each.amplification;
  };
  return error(apart) < error(found) ? apart : found;
}

List<std::complex<double>> response(const Dense<long double>& a, std::complex<double> s) {
  using Complex = std::complex<WideReal>;
  linear::Matrix<Complex> shifted = -wide_matrix(a).cast<Complex>();
  shifted.diagonal().array() += Complex(s.real(), s.imag());
  const linear::Vector<Complex> force = linear::Vector<Complex>::Unit(shifted.rows(), 0),
                                found = linear::solve_fully_pivoted(shifted, force);
  List<std::complex<double>> result;
  for (const Complex& each : found)
    result.emplace_back(static_cast<double>(each.real()), static_cast<double>(each.imag()));
  return result;
}

}  // namespace vcrit::simulation
