#include "realisation/structure.hpp"

#include <algorithm>
#include <cmath>

#include "linear/elimination.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Where each group of parameters begins.
constexpr Index phi_place = 2;
Index frequency_place(const StructureShape& shape) { return phi_place + shape.modes; }
Index factor_place(const StructureShape& shape) { return frequency_place(shape) + shape.modes; }
Index lean_place(const StructureShape& shape) {
  return factor_place(shape) + shape.damping_parameters();
}

template <class Use>
void for_each_factor(const StructureShape& shape, const Use& use) {
  Index place = factor_place(shape);
  for (Index column = 0; column < shape.modes; ++column)
    for (Index row = column; row < shape.modes; ++row)
      if (shape.damping != Damping::modal || row == column) use(place++, row, column);
}

/// M s^2 + C s + K and its solution u for b, at one frequency after the other. The matrix is
/// symmetric and its imaginary part positive, so that elimination needs no pivots: those stay away
/// from 0 as long as there is damping, and a mode without any is in the diagonal alone.
class Balance {
 public:
  explicit Balance(const Structure& structure)
      : damping_(structure.damping_matrix()),
        stiffness_(structure.stiffness_matrix()),
        reach_(structure.reach()),
        matrix_(reach_.size(), reach_.size()),
        solution_(reach_.size()),
        over_(reach_.size()) {}

  // L D L^T by columns, the lower half alone.
  const VectorXcd& solve(double omega) {
    const Index count = reach_.size();
    for (Index j = 0; j < count; ++j)
      for (Index i = j; i < count; ++i)
        matrix_(i, j) = Complex(stiffness_(i, j) - (i == j && i > 0 ? omega * omega : 0),
                                omega * damping_(i, j));
    solution_ = reach_;
    // From the last to the first, as y, without mass, is the stiffest of all.
    for (Index k = count - 1; k >= 0; --k) {
      const Complex over = over_[k] = 1.0 / matrix_(k, k);
      for (Index i = 0; i < k; ++i) {
        const Complex part = multiply(matrix_(k, i), over);
        solution_[i] -= multiply(part, solution_[k]);
        for (Index j = 0; j <= i; ++j) matrix_(i, j) -= multiply(part, matrix_(k, j));
      }
      solution_[k] = multiply(solution_[k], over);
    }
    for (Index k = 1; k < count; ++k) {
      Complex sum = 0;
      for (Index i = 0; i < k; ++i) sum += multiply(matrix_(k, i), solution_[i]);
      solution_[k] -= multiply(over_[k], sum);
    }
    return solution_;
  }
  Complex response(double omega) { return (reach_.transpose() * solve(omega)).value(); }

 private:
  // Without the checks for infinite parts that operator* has.
  static Complex multiply(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  MatrixXd damping_, stiffness_;
  VectorXd reach_;
  MatrixXcd matrix_;
  VectorXcd solution_, over_;  // of the matrix' diagonal, once eliminated, 1/d
};

/// The derivatives of R by the parameters: dR = 2 db.u - u.(d matrix) u, as the matrix is
/// symmetric.
class ResponseSlope {
 public:
  ResponseSlope(const StructureShape& shape, const Structure& structure)
      : shape_(shape), at_(structure), coupling_(structure.coupling()) {
    norm_ = std::sqrt(1 + at_.lean.squaredNorm());
  }

  void fill(double omega, const VectorXcd& u, VectorXcd& slope) const {
    const Complex s(0, omega);
    slope[0] = 2.0 * u[0];
    slope[1] = -u[0] * u[0] * s * at_.tau;
    const auto q = u.tail(shape_.modes);
    for (Index k = 0; k < shape_.modes; ++k) {
      const double w = at_.frequency[k];
      slope[phi_place + k] = 2.0 * q[k];
      slope[frequency_place(shape_) + k] = -2.0 * q[k] * (q[k] * w * w + u[0] * coupling_[k]);
    }
    const VectorXcd along = at_.factor.transpose() * q;
    for_each_factor(shape_, [&](Index place, Index row, Index column) {
      slope[place] = -2.0 * s * q[row] * along[column];
    });
    if (shape_.damping == Damping::coupled) fill_lean(u, slope);
  }

 private:
  void fill_lean(const VectorXcd& u, VectorXcd& slope) const {
    const auto q = u.tail(shape_.modes);
    const VectorXd leant = at_.lean.cwiseProduct(at_.frequency);
    const Complex all = (leant.transpose() * q).value() / (norm_ * norm_ * norm_);
    for (Index k = 0; k < shape_.modes; ++k)
      slope[lean_place(shape_) + k] =
          -2.0 * u[0] * (at_.frequency[k] * q[k] / norm_ - at_.lean[k] * all);
  }

  const StructureShape& shape_;
  const Structure& at_;
  VectorXd coupling_;
  double norm_;
};

}  // namespace

VectorXd Structure::coupling() const {
  return frequency.cwiseProduct(lean) / std::sqrt(1 + lean.squaredNorm());
}

VectorXd Structure::reach() const {
  VectorXd b(modes() + 1);
  b << alpha, phi;
  return b;
}

MatrixXd Structure::damping_matrix() const {
  MatrixXd c = MatrixXd::Zero(modes() + 1, modes() + 1);
  c(0, 0) = tau;
  c.bottomRightCorner(modes(), modes()) = factor * factor.transpose();
  return c;
}

MatrixXd Structure::stiffness_matrix() const {
  MatrixXd k = MatrixXd::Zero(modes() + 1, modes() + 1);
  k(0, 0) = 1;
  k.bottomRightCorner(modes(), modes()) = frequency.array().square().matrix().asDiagonal();
  k.col(0).tail(modes()) = coupling();
  k.row(0).tail(modes()) = coupling().transpose();
  return k;
}

Complex Structure::response(double omega) const { return Balance(*this).response(omega); }

double Structure::static_compliance() const {
  const linear::DenseVector<long double> way = reach().cast<long double>();
  return static_cast<double>(
      way.dot(linear::Ldlt(stiffness_matrix().cast<long double>()).solve(way)));
}

Complex Mode::response(double omega) const {
  return share / Complex(frequency * frequency - omega * omega, 2 * damping * frequency * omega);
}

Structure plus_mode(const Structure& structure, const Mode& mode) {
  const Index modes = structure.modes();
  Structure more = structure;
  for (VectorXd* each : {&more.phi, &more.frequency, &more.lean})
    each->conservativeResize(modes + 1);
  more.phi[modes] = std::sqrt(mode.share);
  more.frequency[modes] = mode.frequency;
  more.lean[modes] = 0;
  more.factor = MatrixXd::Zero(modes + 1, modes + 1);
  more.factor.topLeftCorner(modes, modes) = structure.factor;
  more.factor(modes, modes) = std::sqrt(2 * mode.damping * mode.frequency);
  return more;
}

Structure structure_of(const StructureShape& shape, const VectorXd& parameters) {
  Structure structure;
  structure.alpha = parameters[0];
  structure.tau = std::exp(parameters[1]);
  structure.phi = parameters.segment(phi_place, shape.modes);
  structure.frequency =
      parameters.segment(frequency_place(shape), shape.modes).array().exp().matrix();
  structure.factor = MatrixXd::Zero(shape.modes, shape.modes);
  for_each_factor(shape, [&](Index place, Index row, Index column) {
    structure.factor(row, column) = parameters[place];
  });
  structure.lean = shape.damping == Damping::coupled
                       ? VectorXd(parameters.segment(lean_place(shape), shape.modes))
                       : VectorXd(VectorXd::Zero(shape.modes));
  return structure;
}

VectorXd parameters_of(const StructureShape& shape, const Structure& structure) {
  VectorXd parameters(shape.parameters());
  parameters[0] = structure.alpha;
  parameters[1] = std::log(structure.tau);
  parameters.segment(phi_place, shape.modes) = structure.phi;
  parameters.segment(frequency_place(shape), shape.modes) =
      structure.frequency.array().log().matrix();
  for_each_factor(shape, [&](Index place, Index row, Index column) {
    parameters[place] = structure.factor(row, column);
  });
  if (shape.damping == Damping::coupled)
    parameters.segment(lean_place(shape), shape.modes) = structure.lean;
  return parameters;
}

void keep_in_reach(const StructureShape& shape, const Rows& rows, VectorXd& parameters) {
  // A mode a hundred times beyond the rows is a compliance or a mass to them. Without damping tau
  // is 0: what a billionth of the shortest period leaves of it is less than any digit of a table.
  constexpr double far = 4.6, farther = 20.7;
  // Decay a hundred thousand times as fast as the last row is a damper without mass to it, and a
  // spring that relaxes as much more slowly than the first a damper; more than that would only lose
  // digits when it moves.
  constexpr double fast = 1e5, slow = 11.5;
  const double low = std::log(rows.first()), high = std::log(rows.last());
  parameters[1] = std::clamp(parameters[1], -high - farther, -low + slow);
  const double most = std::sqrt(fast * rows.last());
  auto factors = parameters.segment(factor_place(shape), shape.damping_parameters());
  factors = factors.cwiseMin(most).cwiseMax(-most).eval();
  for (Index k = 0; k < shape.modes; ++k) {
    double& w = parameters[frequency_place(shape) + k];
    w = std::clamp(w, low - far, high + far);
  }
}

void residuals(const StructureShape& shape, const Rows& rows, const VectorXd& parameters,
               VectorXd& residual, MatrixXd* slope) {
  const Structure structure = structure_of(shape, parameters);
  const Index count = rows.size();
  Balance balance(structure);
  const ResponseSlope slopes(shape, structure);
  const VectorXd reach = structure.reach();
  VectorXcd change(shape.parameters());
  residual.resize(2 * count);
  if (slope) slope->resize(2 * count, shape.parameters());
  for (Index i = 0; i < count; ++i) {
    const VectorXcd& u = balance.solve(rows.omega[i]);
    const Complex miss = ((reach.transpose() * u).value() - rows.value[i]) * rows.weight[i];
    residual[i] = miss.real();
    residual[count + i] = miss.imag();
    if (!slope) continue;
    slopes.fill(rows.omega[i], u, change);
    slope->row(i) = change.real().transpose() * rows.weight[i];
    slope->row(count + i) = change.imag().transpose() * rows.weight[i];
  }
}

}  // namespace vcrit::realisation
