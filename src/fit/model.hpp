// What is fitted: a Prony series, as storage and loss stiffness in units of their errors.
//   K(i omega) = k0 + i omega c + sum_j k_j i omega tau_j/(1 + i omega tau_j)
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "scene/stiffness_data.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::fit {

/// Which terms a series has beside its branches.
struct Terms {
  bool equilibrium = true;  ///< the spring k0
  bool damper = false;      ///< the damper c
};

/// The data in units of their standard deviations. Where these are not given, storage and loss are
/// off by the same part of |K| in all rows (noise and a wrong phase do that), and its size is left
/// open: 1 stands for 100 % of |K|.
class Weighed {
 public:
  /// |K| is that of `expected` where it is given, else of the data. Data that noise made small
  /// would count for more than those that it made large.
  explicit Weighed(const StiffnessTable& data, const std::optional<Relaxation>& expected = {});

  Eigen::Index size() const { return target_.size(); }  ///< two a row: storage, loss
  const Eigen::VectorXd& target() const { return target_; }
  double lowest() const { return omega_.front(); }  ///< rad/s
  double highest() const { return omega_.back(); }  ///< rad/s
  bool errors_known() const { return errors_known_; }

  /// What a spring, a damper, and a branch of 1 N/m and `time` (s) add.
  Eigen::VectorXd spring() const;
  Eigen::VectorXd damper() const;
  Eigen::VectorXd branch(double time) const;
  /// By the logarithm of the time.
  Eigen::VectorXd branch_slope(double time) const;

  /// The series less the data.
  Eigen::VectorXd residual(const Relaxation& series) const;

 private:
  Eigen::VectorXd weighed(const std::function<std::complex<double>(double)>& stiffness) const;

  std::vector<double> omega_;
  Eigen::VectorXd weight_, target_;
  bool errors_known_ = false;
};

}  // namespace vcrit::fit
