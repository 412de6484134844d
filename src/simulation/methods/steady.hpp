// The steady cycle of a period map: plain periods until they repeat, or Newton's method with the
// map's derivative by differences.
#pragma once

#include <string>

#include "simulation/methods/methods.hpp"
#include "simulation/methods/period_map.hpp"

namespace vcrit::simulation::methods {

SteadyState settle(PeriodMap& map, const MethodOptions& options);

/// The periods run in one search, within its budget.
class Periods {
 public:
  Periods(PeriodMap& map, int most) : map_(map), most_(most) {}
  Period run(const MapState& state, PeriodAccuracy accuracy = PeriodAccuracy::asked);
  PeriodMap& map() const { return map_; }
  /// What to say when the budget is spent.
  void note(std::string progress) { progress_ = std::move(progress); }

  /// What a period changes in the map's variables, in units of their sizes.
  Eigen::VectorXd change(const MapState& begin, const Period& period) const;

 private:
  PeriodMap& map_;
  int most_, count_ = 0;
  std::string progress_;
};

/// Errors follow tolerance and step only roughly: they are taken twice.
constexpr double caution = 2;

/// Whether a period that slides may hide a stick: its least contact velocity is no larger than the
/// error that the one of less accuracy tells.
bool may_hide_stick(const Period& period, const Period& coarse, double growth = 1);

/// What friction may lack where stick is missed: all of it.
constexpr double missed_stick = 1;

/// Of a period that closes, with an estimate of the error of its friction.
SteadyState answer(Period period, double error);

/// By the trend of the friction over them.
SteadyState plain_periods(Periods& periods, MapState state);

}  // namespace vcrit::simulation::methods
