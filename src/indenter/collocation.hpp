// Ordinary differential equations x' = f(t, x), stiff ones too, by Radau IIA collocation of seven
// stages (order 13; Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5). A step is
// a polynomial in time: it can be asked everywhere, for events and for what was before.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "base/effort.hpp"
#include "indenter/shifted_lu.hpp"

namespace vcrit::indenter {

using StateVector = Eigen::VectorXd;
using Rates = std::function<void(double t, const StateVector& x, StateVector& rates)>;

/// One step, from t = begin to begin + length.
class TimeStep {
 public:
  static constexpr int nodes = 7;  ///< at which rates are asked

  double begin() const { return begin_; }
  double end() const { return end_; }
  /// From there on the motion is another one.
  void end_at(double t) { end_ = t; }

  StateVector at(double t) const;
  struct WithRate {
    double value, rate;
  };
  WithRate with_rate(double t, Eigen::Index i) const;

 private:
  friend class Collocation;
  double begin_ = 0, length_ = 0, end_ = 0;
  StateVector from_;
  Eigen::MatrixXd powers_;  ///< column i: of (t - begin)/length to the power of i + 1
};

class Collocation {
 public:
  /// tolerance: on a step, absolute, of numbers that are about 1. whole: of which its effort is a
  /// part, none without.
  Collocation(Rates rates, double tolerance, SharedEffort* whole);

  /// From x at t over `length` > 0, or less if the tolerance wants it. `next_length` is what the
  /// step after it may have. Throws ModelError where steps become too short, or too many
  /// (effort_of_state).
  TimeStep step(double t, const StateVector& x, double length);
  double next_length() const { return next_length_; }

 private:
  bool solve(double t, const StateVector& x, double length);
  void iterate(double t, const StateVector& x, double length);
  void slopes(double t, const StateVector& x);
  double fault(double length) const;

  Rates rates_;
  Effort effort_;
  double tolerance_, next_length_ = 0;
  /// stages_: rates at the nodes, one a column, as residual_ and change_ are.
  Eigen::MatrixXd jacobian_, stages_, residual_, change_;
  StateVector value_, rate_, moved_;
  std::vector<ShiftedLu> factors_;  ///< of the equations that a step's fall apart into
  Eigen::VectorXcd part_, found_;   ///< of one of them
};

}  // namespace vcrit::indenter
