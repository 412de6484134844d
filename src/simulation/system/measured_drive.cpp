#include "simulation/system/measured_drive.hpp"

#include <cmath>
#include <utility>

#include "realisation/realisation.hpp"

namespace vcrit::simulation {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using realisation::Structure;

Dense<long double> dense(const MatrixXd& matrix) {
  const auto size = static_cast<std::size_t>(matrix.rows());
  Dense<long double> result(size, size);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      result(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = matrix(i, j);
  return result;
}

std::vector<long double> numbers_of(const VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

// Where nothing gives at the end but the modes, the end would be rigid: a spring that a thousandth
// of a billionth of what gives would not tell from one.
double least_alpha(const Structure& structure) {
  const double compliance = structure.phi.cwiseQuotient(structure.frequency).squaredNorm();
  return std::copysign(std::max(std::abs(structure.alpha), 1e-6 * std::sqrt(compliance)),
                       structure.alpha);
}

// y = (x - phi.q)/alpha: rows of (y, q) by (x, q).
MatrixXd by_end(const Structure& structure) {
  const double alpha = least_alpha(structure);
  MatrixXd change = MatrixXd::Identity(structure.modes() + 1, structure.modes() + 1);
  change(0, 0) = 1 / alpha;
  change.row(0).tail(structure.modes()) = -structure.phi.transpose() / alpha;
  return change;
}

DriveStructure with_body(const Structure& structure, double mass) {
  const MatrixXd change = by_end(structure);
  const auto size = static_cast<std::size_t>(change.rows());
  DriveStructure drive;
  drive.mass.assign(size, 1);
  drive.mass[0] = mass;
  drive.damping = dense(change.transpose() * structure.damping_matrix() * change);
  drive.stiffness = dense(change.transpose() * structure.stiffness_matrix() * change);
  drive.port.assign(size, 0);
  drive.port[0] = 1;
  // How its masses stood at rest the table does not say: the body moves alone.
  drive.together = drive.port;
  return drive;
}

Relaxation end_of(const Structure& structure) {
  const double alpha = least_alpha(structure);
  return {1 / (alpha * alpha), structure.tau / (alpha * alpha), {}};
}

DriveStructure without_body(const Structure& structure) {
  const Eigen::Index modes = structure.modes();
  DriveStructure drive;
  drive.mass.assign(static_cast<std::size_t>(modes), 1);
  drive.damping = dense(structure.damping_matrix().bottomRightCorner(modes, modes));
  drive.stiffness = dense(structure.stiffness_matrix().bottomRightCorner(modes, modes));
  drive.port = numbers_of(structure.phi);
  drive.together = numbers_of(structure.phi / structure.phi.squaredNorm());
  drive.lead = end_of(structure);
  return drive;
}

}  // namespace

void hold_by_structure(System& system, const Structure& structure, std::optional<double> mass) {
  if (structure.modes() == 0) {
    system.masses.reset();
    system.drive = end_of(structure);
    system.mass = mass;
  } else {
    hold_by(system, mass ? with_body(structure, *mass) : without_body(structure));
  }
}

void hold_by_table(System& system, const Receptance& table, std::optional<double> mass) {
  const auto body = mass ? realisation::BodyMass::heavy : realisation::BodyMass::none;
  hold_by_structure(system, realisation::realised(table, body)->structure(), mass);
}

}  // namespace vcrit::simulation
