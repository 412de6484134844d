#include "stiffness/drive_motion.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "linear/elimination.hpp"
#include "linear/orthogonal.hpp"
#include "stiffness/structure_check.hpp"

namespace vcrit {

namespace {

using MotionReal = long double;
using MotionMatrix = linear::DenseMatrix<MotionReal>;
using MotionColumn = linear::DenseVector<MotionReal>;

// What is left of a mass's own stiffness by less than this share is none: rounding of the sums that
// make it.
constexpr MotionReal no_stiffness = 1e-17L;

// What of A^k F is new by less than this share is rounding of the drive's numbers, which are
// doubles: the body sees the square of it. And of the terms of the last step by less than the
// second: not of all of A, where one part may relax very much faster than those that matter.
constexpr MotionReal no_part = 64 * epsilon, no_share_of_terms = 1e-18L;

Eigen::Index place_at(std::size_t i) { return static_cast<Eigen::Index>(i); }

// All of the drive in units of energy.
struct WholeDrive {
  explicit WholeDrive(const DriveStructure& structure) {
    const Eigen::Index n = place_at(structure.mass.size());
    root.resize(n);
    port.resize(n);
    together.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto node = static_cast<std::size_t>(i);
      root[i] = std::sqrt(static_cast<MotionReal>(structure.mass[node]));
      port[i] = structure.port[node] / root[i];
      together[i] = structure.together[node] * root[i];
    }
    damping.resize(n, n);
    MotionMatrix stiffness(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        damping(i, j) = structure.damping(a, b) / (root[i] * root[j]);
        stiffness(i, j) = structure.stiffness(a, b) / (root[i] * root[j]);
      }
    require_si_doubles(damping.allFinite() && stiffness.allFinite());
    split(stiffness);
    for (const DriveBranch& branch : structure.branches) {
      MotionColumn pull(n);
      for (Eigen::Index i = 0; i < n; ++i)
        pull[i] = std::sqrt(branch.stiffness) * branch.pull[static_cast<std::size_t>(i)] / root[i];
      add_elongation(pull, 1 / branch.time);
    }
  }

  // Springs by Cholesky's factors, which know a soft spring of a heavy mass as well as a stiff one
  // of a light mass: eigenvalues have the rounding of the largest. The mass of which the others
  // take the least goes first; those of which nothing is left move freely.
  void split(MotionMatrix stiffness) {
    const Eigen::Index n = stiffness.rows();
    const MotionColumn own = stiffness.diagonal();
    std::vector<Eigen::Index> held, rest;
    for (Eigen::Index i = 0; i < n; ++i) rest.push_back(i);
    elongations.resize(n, 0);
    const auto left = [&](Eigen::Index i) { return own[i] > 0 ? stiffness(i, i) / own[i] : 0; };
    while (!rest.empty()) {
      const auto next = std::ranges::max_element(rest, {}, left);
      const Eigen::Index i = *next;
      if (!(left(i) > no_stiffness * static_cast<MotionReal>(n))) break;
      const MotionColumn pull = stiffness.col(i) / std::sqrt(stiffness(i, i));
      stiffness -= pull * pull.transpose();
      stiffness.row(i).setZero();
      stiffness.col(i).setZero();
      add_elongation(pull, 0);
      held.push_back(i);
      rest.erase(next);
    }
    set_free(held, rest);
  }

  // Each mass that nothing is left of by 1, and the others so that no spring is longer.
  void set_free(const std::vector<Eigen::Index>& held, const std::vector<Eigen::Index>& rest) {
    free = MotionMatrix::Zero(elongations.rows(), static_cast<Eigen::Index>(rest.size()));
    for (std::size_t k = 0; k < rest.size(); ++k) {
      auto way = free.col(place_at(k));
      way[rest[k]] = 1;
      for (std::size_t j = held.size(); j-- > 0;) {
        const auto pull = elongations.col(place_at(j));
        way[held[j]] = -pull.dot(way) / pull[held[j]];
      }
      way /= way.norm();
    }
  }

  void add_elongation(const MotionColumn& pull, MotionReal rate) {
    elongations.conservativeResize(pull.size(), elongations.cols() + 1);
    elongations.col(elongations.cols() - 1) = pull;
    rates.push_back(rate);
  }

  MotionMatrix matrix() const {
    const Eigen::Index n = damping.rows(), m = elongations.cols();
    MotionMatrix a = MotionMatrix::Zero(n + m, n + m);
    a.topLeftCorner(n, n) = -damping;
    a.topRightCorner(n, m) = -elongations;
    a.bottomLeftCorner(m, n) = elongations.transpose();
    for (Eigen::Index j = 0; j < m; ++j) a(n + j, n + j) = -rates[static_cast<std::size_t>(j)];
    return a;
  }

  // A constant force moves it along its free directions alone, against what flows there.
  MotionReal fluidity() const {
    if (free.cols() == 0) return 0;
    const MotionColumn force = free.transpose() * port;
    MotionMatrix flowing = damping;
    for (Eigen::Index j = 0; j < elongations.cols(); ++j)
      if (const MotionReal rate = rates[static_cast<std::size_t>(j)]; rate > 0)
        flowing += elongations.col(j) * elongations.col(j).transpose() / rate;
    const MotionMatrix held = free.transpose() * flowing * free;
    require_si_doubles(held.allFinite());
    const auto eigen = linear::symmetric_eigen(held);
    if (!(eigen.values.minCoeff() > 0))
      throw ModelError(
          "nothing but masses leads from the body to the far end of the drive: it pulls nothing",
          "a spring or damper to the far end");
    if (force.norm() <= no_part * port.norm()) return 0;
    return force.dot(linear::Cholesky(held).solve(force));
  }

  MotionColumn root, port, together;
  MotionMatrix damping, elongations, free;
  std::vector<MotionReal> rates;
};

// An orthonormal basis of what a force on the body's end can reach, that end first.
MotionMatrix reachable(const MotionMatrix& a, const MotionColumn& port) {
  const Eigen::Index n = a.rows();
  MotionMatrix basis = MotionMatrix::Zero(n, 1);
  basis.col(0).head(port.size()) = port / port.norm();
  const MotionMatrix sizes = a.cwiseAbs();
  while (basis.cols() < n) {
    MotionColumn next = a * basis.rightCols(1);
    const MotionReal size = next.norm(), terms = (sizes * basis.rightCols(1).cwiseAbs()).norm();
    for (int i = 0; i < 3; ++i) next -= basis * (basis.transpose() * next);
    const MotionReal left = next.norm();
    if (!(left > no_part * size && left > no_share_of_terms * terms)) break;
    basis.conservativeResize(n, basis.cols() + 1);
    basis.col(basis.cols() - 1) = next / left;
  }
  return basis;
}

}  // namespace

DriveMotion drive_motion(const DriveStructure& structure) {
  check_structure(structure);
  const WholeDrive whole(structure);
  const MotionMatrix all = whole.matrix(), basis = reachable(all, whole.port);
  const MotionMatrix a = basis.transpose() * all * basis;
  const MotionReal root = 1 / whole.port.norm();
  DriveMotion result;
  result.mass = static_cast<double>(root * root);
  result.fluidity = static_cast<double>(whole.fluidity());
  MotionColumn rest = MotionColumn::Zero(all.rows());
  rest.head(whole.together.size()) = whole.together / root;
  rest = (basis.transpose() * rest).eval();
  for (const MotionReal each : rest) result.rest.push_back(static_cast<double>(each));
  result.rates =
      Dense<MotionReal>(static_cast<std::size_t>(a.rows()), static_cast<std::size_t>(a.cols()));
  for (std::size_t i = 0; i < result.rates.rows(); ++i)
    for (std::size_t j = 0; j < result.rates.columns(); ++j)
      result.rates(i, j) = a(place_at(i), place_at(j));
  const auto poles = linear::eigenvalues(a);
  result.poles.assign(poles.begin(), poles.end());
  return result;
}

}  // namespace vcrit
