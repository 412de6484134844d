// Newton's method on a period map: its derivative by forward differences, and Broyden's update
// while that converges.
#pragma once

#include <optional>

#include "linear/elimination.hpp"
#include "simulation/methods/steady.hpp"

namespace vcrit::simulation::methods {

class Newton {
 public:
  Newton(Periods& periods, MapState start);

  bool converges();
  /// The steady cycle that it converged to.
  SteadyState found();
  /// Where it stands, and where the step that it did not take would have led after a period.
  const MapState& best() const { return state_; }
  const std::optional<MapState>& rejected() const { return rejected_; }

 private:
  using MapVector = Eigen::VectorXd;

  MapState moved(const MapVector& by) const;
  void differentiate();
  void solve();
  bool done() const;
  bool close() const;
  bool advance();
  void update(const Period& after);

  Periods& periods_;
  MapState state_;
  std::vector<Eigen::Index> variables_;
  Period period_;
  MapVector rest_;  ///< what the period changes
  // Change of the end of the period and of 1 - mu_macro/mu0 with the variables at its beginning.
  Eigen::MatrixXd end_by_begin_;
  Eigen::RowVectorXd deficit_by_begin_;
  linear::Lu<double> solver_;
  MapVector step_;
  bool stalled_ = false;
  std::optional<MapState> rejected_;
};

}  // namespace vcrit::simulation::methods
