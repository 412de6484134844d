#include "fit/model.hpp"

#include <algorithm>
#include <cmath>

namespace vcrit::fit {

using Eigen::Index;
using Eigen::VectorXd;

Weighed::Weighed(const Data& data) : errors_known_(data.has_errors) {
  const auto rows = static_cast<Index>(data.rows.size());
  weight_.resize(2 * rows);
  target_.resize(2 * rows);
  for (Index i = 0; i < rows; ++i) {
    const Row& row = data.rows[static_cast<std::size_t>(i)];
    const double least = least_part * std::hypot(row.storage, row.loss);
    weight_[2 * i] = 1 / (errors_known_ ? row.storage_error : std::max(row.storage, least));
    weight_[2 * i + 1] = 1 / (errors_known_ ? row.loss_error : std::max(row.loss, least));
    target_[2 * i] = row.storage * weight_[2 * i];
    target_[2 * i + 1] = row.loss * weight_[2 * i + 1];
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
