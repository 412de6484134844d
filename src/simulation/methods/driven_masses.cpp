#include "simulation/methods/driven_masses.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "linear/elimination.hpp"

namespace vcrit::simulation::methods {

namespace {

using Eigen::Index;
using Wide = linear::DenseMatrix<long double>;
using WideVector = linear::DenseVector<long double>;

Wide matrix_of(const Dense<long double>& numbers) {
  return Wide::NullaryExpr(static_cast<Index>(numbers.rows()),
                           static_cast<Index>(numbers.columns()), [&](Index i, Index j) {
                             return numbers(static_cast<std::size_t>(i),
                                            static_cast<std::size_t>(j));
                           });
}

WideVector vector_of(const std::vector<long double>& numbers) {
  return Eigen::Map<const WideVector>(numbers.data(), static_cast<Index>(numbers.size()));
}

struct Held {
  long double stiffness, rate;
  WideVector pull;
};

// K = P^T L D L^T P as springs: each of D on a column of P^T L. A row of the elimination that is
// but rounding holds nothing.
std::vector<Held> springs(const linear::Ldlt& factors) {
  const Wide shapes = factors.shapes();
  const WideVector d = factors.diagonal();
  const long double least = static_cast<long double>(d.size()) * epsilon * d.maxCoeff();
  std::vector<Held> result;
  for (Index j = 0; j < d.size(); ++j)
    if (d[j] > least) result.push_back({d[j], 0, shapes.col(j)});
  return result;
}

}  // namespace

DrivenMasses::DrivenMasses(const DriveStructure& structure, double omega, double stiffness_unit)
    : masses_(structure.mass.size()) {
  const auto n = static_cast<Index>(masses_);
  const Wide stiffness = matrix_of(structure.stiffness) / stiffness_unit;
  const Wide damping = matrix_of(structure.damping) * (omega / stiffness_unit);
  const linear::Ldlt factors(stiffness);
  std::vector<Held> held = springs(factors);
  const bool anchored = static_cast<Index>(held.size()) == n;
  for (const DriveBranch& branch : structure.branches) {
    held.push_back(
        {branch.stiffness / stiffness_unit, 1 / (branch.time * omega), vector_of(branch.pull)});
    slowest_ = std::min(slowest_, static_cast<double>(held.back().rate));
  }

  const Index size = n + static_cast<Index>(held.size());
  const WideVector port = vector_of(structure.port);
  rates_ = Eigen::MatrixXd::Zero(size, size);
  push_ = Eigen::VectorXd::Zero(size);
  port_ = port.transpose().cast<double>();
  together_ = vector_of(structure.together).cast<double>();
  for (Index i = 0; i < n; ++i) {
    const double mass =
        structure.mass[static_cast<std::size_t>(i)] * omega * (omega / stiffness_unit);
    push_[i] = -port_[i] / mass;
    for (Index j = 0; j < n; ++j) rates_(i, j) = -static_cast<double>(damping(i, j)) / mass;
    for (Index j = n; j < size; ++j)
      rates_(i, j) = -static_cast<double>(held[static_cast<std::size_t>(j - n)].pull[i]) / mass;
  }
  dragged_ = Eigen::VectorXd::Zero(size);
  const WideVector q = anchored ? WideVector(factors.solve(-port)) : WideVector::Zero(n);
  for (Index j = n; j < size; ++j) {
    const Held& each = held[static_cast<std::size_t>(j - n)];
    for (Index i = 0; i < n; ++i) rates_(j, i) = static_cast<double>(each.stiffness * each.pull[i]);
    rates_(j, j) = -static_cast<double>(each.rate);
    if (each.rate == 0) dragged_[j] = static_cast<double>(each.stiffness * each.pull.dot(q));
  }
}

double DrivenMasses::end_velocity(const double* x) const {
  return port_.dot(Eigen::Map<const Eigen::RowVectorXd>(x, port_.size()));
}

void DrivenMasses::rates(const double* x, double force, double* dxdt) const {
  const auto n = rates_.rows();
  Eigen::Map<Eigen::VectorXd>(dxdt, n) =
      rates_ * Eigen::Map<const Eigen::VectorXd>(x, n) + force * push_;
}

Eigen::VectorXd DrivenMasses::at_rest(double velocity) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(rates_.rows());
  x.head(together_.size()) = -velocity * together_;
  return x;
}

std::vector<double> DrivenMasses::scales(double velocity) const {
  std::vector<double> result(size(), 1.0);
  for (std::size_t i = 0; i < masses_; ++i) {
    const auto row = static_cast<Index>(i);
    result[i] = std::max(velocity, rates_.row(row).tail(rates_.cols() - port_.size()).norm() /
                                       (1 + rates_.row(row).norm()));
  }
  return result;
}

// By Gershgorin's circles of A^2 for what swings, and of A for what relaxes.
double DrivenMasses::fastest_rate(double damper, double spring) const {
  const auto n = static_cast<Index>(masses_);
  const double relaxing = std::max(rates_.topLeftCorner(n, n).cwiseAbs().rowwise().sum().maxCoeff(),
                                   rates_.diagonal().cwiseAbs().maxCoeff());
  const double swinging = (rates_.topRightCorner(n, rates_.cols() - n).cwiseAbs() *
                           rates_.bottomLeftCorner(rates_.rows() - n, n).cwiseAbs())
                              .rowwise()
                              .sum()
                              .maxCoeff();
  const double end = push_.cwiseAbs().maxCoeff();
  return std::max(relaxing + damper * end, std::sqrt(swinging + spring * end));
}

}  // namespace vcrit::simulation::methods
