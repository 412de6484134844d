// What a time integrator does to the state in one period of the oscillation: all that the search
// for the steady cycle needs to know of a method.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/constants.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::simulation::methods {

struct MapState {
  Eigen::VectorXd y;
  Motion motion = Motion::slip;  ///< read by methods that switch
};

struct Period {
  MapState end;
  double deficit = 0;         ///< 1 - mu_macro/mu0 over the period
  std::vector<Event> events;  ///< as they came
  /// Least contact velocity of a method whose steps may be longer than a stick.
  double slowest = infinity;

  bool slides() const { return events.empty() && end.motion == Motion::slip; }
};

enum class PeriodAccuracy {
  asked,
  coarser,  ///< as much that the difference tells the error
};

class PeriodMap {
 public:
  virtual ~PeriodMap() = default;
  virtual MapState start(Start start) const = 0;
  /// Throws ModelError when the integration goes wrong.
  virtual Period run(const MapState& state, PeriodAccuracy accuracy = PeriodAccuracy::asked) = 0;
  /// Moves the beginning of the period to where the map is smooth; the state there.
  virtual MapState to_smooth_section(const MapState& state) { return state; }
  /// The entries of y that may be varied independently, and their typical sizes.
  virtual std::vector<Eigen::Index> variables(const MapState& state) const = 0;
  virtual double scale(Eigen::Index variable) const = 0;
  /// What cycles that repeat differ by, as the method is not more accurate; and by how much the
  /// friction may still change when plain periods end.
  virtual double noise() const = 0;
  virtual double target() const = 0;
  /// An error of the friction that no comparison of accuracies tells.
  virtual double resolution() const { return 0; }
  /// Smallest rate above 0 at which a force in the system relaxes.
  virtual double slowest_rate() const = 0;
};

}  // namespace vcrit::simulation::methods
