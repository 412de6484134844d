#include "fit/model.hpp"

#include <cmath>

namespace vcrit::fit {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Sizes {
  double storage, loss;
};

Sizes sizes(const StiffnessRow& row, bool errors_known, const std::optional<Relaxation>& expected) {
  if (errors_known) return {row.storage_error, row.loss_error};
  const double size = expected ? std::abs(dynamic_stiffness(*expected, row.omega))
                               : std::hypot(row.storage, row.loss);
  return {size, size};
}

}  // namespace

Weighed::Weighed(const StiffnessTable& data, const std::optional<Relaxation>& expected)
    : errors_known_(data.has_errors) {
  const auto rows = static_cast<Index>(data.rows.size());
  weight_.resize(2 * rows);
  target_.resize(2 * rows);
  for (Index i = 0; i < rows; ++i) {
    const StiffnessRow& row = data.rows[static_cast<std::size_t>(i)];
    const auto [storage, loss] = sizes(row, errors_known_, expected);
    weight_[2 * i] = 1 / storage;
    weight_[2 * i + 1] = 1 / loss;
    target_[2 * i] = row.storage / storage;
    target_[2 * i + 1] = row.loss / loss;
    omega_.push_back(row.omega);
  }
}

VectorXd Weighed::weighed(const std::function<std::complex<double>(double)>& stiffness) const {
  VectorXd result(size());
  for (std::size_t row = 0; row < omega_.size(); ++row) {
    const std::complex<double> value = stiffness(omega_[row]);
    const auto i = static_cast<Index>(2 * row);
    result[i] = value.real() * weight_[i];
    result[i + 1] = value.imag() * weight_[i + 1];
  }
  return result;
}

VectorXd Weighed::spring() const {
  return weighed([](double) { return std::complex<double>(1, 0); });
}

VectorXd Weighed::damper() const {
  return weighed([](double omega) { return std::complex<double>(0, omega); });
}

VectorXd Weighed::branch(double time) const {
  return weighed([&](double omega) {
    const std::complex<double> x(0, omega * time);
    return x / (1.0 + x);
  });
}

VectorXd Weighed::branch_slope(double time) const {
  return weighed([&](double omega) {
    const std::complex<double> x(0, omega * time);
    return x / ((1.0 + x) * (1.0 + x));
  });
}

VectorXd Weighed::residual(const Relaxation& series) const {
  return weighed([&](double omega) { return dynamic_stiffness(series, omega); }) - target_;
}

}  // namespace vcrit::fit
