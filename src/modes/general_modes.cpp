#include "modes/general_modes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
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
using WideMatrix = linear::DenseMatrix<WideReal>;
using WideColumn = linear::DenseVector<WideReal>;
using WideComplexMatrix = linear::DenseMatrix<std::complex<WideReal>>;
using WideComplexColumn = linear::DenseVector<std::complex<WideReal>>;

// Of the norm of A: what is left of a rate that is 0, of some dozen modes.
constexpr WideReal no_rate = 2e-18L;

// Below this share of the norm of A, rounding takes a double's digits from a mode: it is found
// anew.
constexpr WideReal slow_mode = 1e-3L;

// How far a shift stands off a mode: half of its digits. On the mode nothing would be left to
// divide by, and where two modes meet one divides by this twice.
WideReal off_mode(WideReal mode) { return 1e-9L * std::abs(mode); }

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

}  // namespace

/// As GeneralModes has them, in more digits.
struct WideModes {
  std::vector<WideReal> rates;
  std::vector<std::pair<WideReal, WideReal>> pairs;  ///< decay, q
  WideMatrix from, to;
  double amplification = 1, change = 0;
};

namespace {

// ((A + decay)^2 - q)^-1, by its two factors. The square itself would hold the rounding of the
// square of the norm, which hides slow modes beside a fast one.
class NearModes {
 public:
  NearModes(const WideMatrix& a, WideReal decay, WideReal q) {
    const std::complex<WideReal> distance = std::sqrt(std::complex<WideReal>(q));
    const auto shifted = [&](std::complex<WideReal> s) {
      WideComplexMatrix result = a.cast<std::complex<WideReal>>();
      result.diagonal().array() += s + off_mode(std::abs(s));
      return linear::Lu<std::complex<WideReal>>(result);
    };
    one_ = shifted(decay + distance);
    other_ = shifted(decay - distance);
  }

  WideColumn weighed(const WideColumn& x) const {
    const WideComplexColumn once = one_.solve(WideComplexColumn(x.cast<std::complex<WideReal>>()));
    return other_.solve(once).real();
  }

 private:
  linear::Lu<std::complex<WideReal>> one_, other_;
};

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

  WideModes modes() const {
    const Eigen::Index n = a_.rows();
    WideModes result;
    result.from.resize(n, n);
    Eigen::Index column = 0;
    for (const auto& [rate, shape] : singles_) {
      result.rates.push_back(rate);
      result.from.col(column++) = shape;
    }
    for (const Plane& plane : planes_) {
      result.pairs.emplace_back(plane.decay, plane.q);
      result.from.col(column++) = plane.a;
      result.from.col(column++) = plane.b;
    }
    result.to = linear::Lu<WideReal>(result.from).inverse();
    result.amplification =
        static_cast<double>((result.from.cwiseAbs() * result.to.cwiseAbs()).maxCoeff());
    return result;
  }

 private:
  struct Plane {
    WideReal decay, q;
    WideColumn a, b;
  };

  bool is_slow(std::complex<WideReal> s) const { return std::abs(s) < slow_mode * size_; }

  // What is below 0, or as small as rounding, is none.
  WideReal decaying(WideReal rate) const { return rate > no_rate * size_ ? rate : 0; }
  WideReal decaying(WideReal rate, const WideMatrix& shapes) const {
    return rate > no_rate * terms_of(shapes) ? rate : 0;
  }
  // Sizes of the terms of A for shapes of length 1: what they hardly move in has no part in them.
  WideReal terms_of(const WideMatrix& shapes) const {
    const WideMatrix parts = shapes.cwiseAbs();
    return (parts.transpose() * a_.cwiseAbs() * parts).diagonal().maxCoeff();
  }

  void add_single(Eigen::Index i) {
    const WideReal rate = -eigen_.values[i].real();
    WideColumn shape = eigen_.shapes.col(i) / eigen_.shapes.col(i).norm();
    if (!is_slow(rate)) {
      singles_.emplace_back(decaying(rate), shape);
      return;
    }
    // By inverse iteration, whose elimination takes fast parts off before it comes to slow ones.
    WideReal found = rate;
    for (int turn = 0; turn < 2; ++turn) {
      const WideReal shift = off_mode(found) - found;
      const linear::Lu<WideReal> solver = shifted(shift);
      for (int k = 0; k < 2; ++k) {
        const WideColumn next = solver.solve(WideMatrix(shape)).col(0);
        if (!next.allFinite()) break;  // the shift is the mode, to all digits
        found = -(shift + shape.dot(next) / next.squaredNorm());
        shape = next / next.norm();
      }
    }
    singles_.emplace_back(decaying(found, shape), shape);
  }

  void add_pair_of(Eigen::Index i) {
    const std::complex<WideReal> s = eigen_.values[i];
    if ((is_slow(s) || s.imag() < close_modes * std::abs(s)) &&
        add_plane(-s.real(), -s.imag() * s.imag()))
      return;
    const WideReal norm = eigen_.shapes.middleCols(i, 2).norm();
    const WideColumn real = eigen_.shapes.col(i) / norm,
                     imaginary = eigen_.shapes.col(i + 1) / norm;
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

  // What A does in the plane, from its inverse beside a shift that no decaying mode has: the terms
  // of A itself cancel where a mode is slow.
  Eigen::Matrix<WideReal, 2, 2> inside_of(const WideMatrix& plane, WideReal decay,
                                          WideReal q) const {
    const WideReal shift = 2 * (std::abs(decay) + std::sqrt(std::abs(q)));
    Eigen::Matrix<WideReal, 2, 2> inverse = plane.transpose() * shifted(shift).solve(plane);
    Eigen::Matrix<WideReal, 2, 2> inside;
    const WideReal determinant = inverse(0, 0) * inverse(1, 1) - inverse(0, 1) * inverse(1, 0);
    inside << inverse(1, 1), -inverse(0, 1), -inverse(1, 0), inverse(0, 0);
    inside /= determinant;
    inside.diagonal().array() += shift;
    return inside;
  }

  linear::Lu<WideReal> shifted(WideReal shift) const {
    WideMatrix result = a_;
    result.diagonal().array() -= shift;
    return linear::Lu<WideReal>(result);
  }

  // The plane on which (A + decay)^2 - q vanishes, by inverse iteration; it gives both numbers
  // better than the eigenvalues, which lose half of their digits where they meet. Nothing where
  // both modes are independent of each other at one rate.
  bool add_plane(WideReal decay, WideReal q) {
    const Eigen::Index n = a_.rows();
    const NearModes near(a_, decay, q);
    WideMatrix plane(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      plane(i, 0) = std::cos(static_cast<WideReal>(i + 1));
      plane(i, 1) = std::sin(static_cast<WideReal>(2 * i + 1));
    }
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 2; ++k) plane.col(k) = near.weighed(plane.col(k));
      plane.col(0) /= plane.col(0).norm();
      for (int k = 0; k < 2; ++k) plane.col(1) -= plane.col(0) * plane.col(0).dot(plane.col(1));
      plane.col(1) /= plane.col(1).norm();
    }
    Eigen::Matrix<WideReal, 2, 2> inside = inside_of(plane, decay, q);
    if (!inside.allFinite()) return false;
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
    planes_.push_back({decaying(-mean, plane), exact, plane * best, plane * (inside * best)});
    return true;
  }

  WideMatrix a_;
  WideReal size_;
  linear::GeneralEigen eigen_;
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

WideModes decomposed(const Dense<long double>& a) {
  const WideMatrix exact = wide_matrix(a);
  WideModes found = Decomposition(exact).modes();
  if (found.amplification < worst_amplification) return found;
  WideModes apart = Decomposition(changed(exact, small_change)).modes();
  apart.change = static_cast<double>(small_change);
  const auto error = [](const WideModes& each) {
    return each.change + epsilon * each.amplification;
  };
  return error(apart) < error(found) ? apart : found;
}

// Of a pair's parts the first is as large as the inverse of a rate.
GeneralModes per_unit(const WideModes& wide, WideReal unit) {
  GeneralModes result;
  for (const WideReal rate : wide.rates)
    result.modes.spectrum.rates.push_back(static_cast<double>(rate / unit));
  for (const auto& [decay, q] : wide.pairs)
    result.modes.spectrum.pairs.emplace_back(static_cast<double>(decay / unit),
                                             static_cast<double>(q / unit / unit));
  const auto singles = static_cast<Eigen::Index>(wide.rates.size()), n = wide.to.rows();
  const auto size = [&](Eigen::Index mode) {
    return mode >= singles && (mode - singles) % 2 == 0 ? unit : 1;
  };
  result.modes.to_modes = result.modes.from_modes =
      Matrix(static_cast<Index>(n), static_cast<Index>(n));
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto row = static_cast<Index>(i), column = static_cast<Index>(j);
      result.modes.to_modes(row, column) = static_cast<double>(wide.to(i, j) / size(i));
      result.modes.from_modes(row, column) = static_cast<double>(wide.from(i, j) * size(j));
    }
  result.amplification = wide.amplification;
  result.change = wide.change;
  return result;
}

}  // namespace

// A grid asks for the modes of one drive at all of its points: those in slip, and over amplitudes
// and loads those in stick as well.
class KnownModes::Last {
 public:
  const WideModes& of(const Dense<long double>& a) {
    for (const Found& each : found_)
      if (each.a.rows() == a.rows() && each.a.numbers() == a.numbers()) return each.modes;
    next_ = (next_ + 1) % found_.size();
    found_[next_] = {a, decomposed(a)};
    return found_[next_].modes;
  }

 private:
  struct Found {
    Dense<long double> a;
    WideModes modes;
  };
  std::array<Found, 4> found_;
  std::size_t next_ = 0;
};

KnownModes::KnownModes() = default;
KnownModes::~KnownModes() = default;

GeneralModes KnownModes::of(const Dense<long double>& a, double unit) {
  if (!last_) last_ = std::make_unique<Last>();
  return per_unit(last_->of(a), unit);
}

GeneralModes general_modes(const Dense<long double>& a, double unit, KnownModes* known) {
  return known != nullptr ? known->of(a, unit) : per_unit(decomposed(a), unit);
}

namespace {

// (s - A)^-1 e_1 in numbers that hold s.
template <class Number>
List<std::complex<double>> response_in(const Dense<long double>& a, Number s) {
  linear::DenseMatrix<Number> shifted = -wide_matrix(a).cast<Number>();
  shifted.diagonal().array() += s;
  const linear::DenseVector<Number> force = linear::DenseVector<Number>::Unit(shifted.rows(), 0),
                                    found = linear::solve_fully_pivoted(shifted, force);
  List<std::complex<double>> result;
  for (const std::complex<WideReal> each : found)
    result.emplace_back(static_cast<double>(each.real()), static_cast<double>(each.imag()));
  return result;
}

}  // namespace

List<std::complex<double>> response(const Dense<long double>& a, std::complex<double> s) {
  if (s.imag() == 0) return response_in<WideReal>(a, s.real());
  return response_in(a, std::complex<WideReal>(s.real(), s.imag()));
}

}  // namespace vcrit::simulation
