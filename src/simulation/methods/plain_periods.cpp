// Periods run one after the other until the trend of the friction leaves no more to come.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "simulation/methods/steady.hpp"

namespace vcrit::simulation::methods {

namespace {

/// 1 - mu_macro/mu0, period by period.
class Deficits {
 public:
  explicit Deficits(const PeriodMap& map) : map_(map) {}

  void add(double deficit) { list_.push_back(deficit); }
  std::size_t size() const { return list_.size(); }

  // What is still to come if the spread goes on falling as it did between the last two quarters.
  double trend() const {
    const double late = spread(1), early = spread(2);
    if (early <= 2 * map_.noise()) return late;
    const double share = late / early;
    return share < 1 ? late * std::max(0.5, share / (1 - share)) : infinity;
  }

  // The same if all of it is the beginning of the slowest relaxation, which a trend shows too late.
  double slowest_trend() const { return spread(1) * slowness(quarter() - 1); }

  /// What is to come of the slowest relaxation, over what so many periods change.
  double slowness(std::size_t periods) const {
    return 1 / -std::expm1(-two_pi * map_.slowest_rate() * static_cast<double>(periods));
  }

 private:
  std::size_t quarter() const { return list_.size() / 4; }

  // Over the last quarter of the periods (1), or the one before it (2).
  double spread(std::size_t place) const {
    const auto length = static_cast<std::ptrdiff_t>(quarter());
    const auto first = list_.end() - static_cast<std::ptrdiff_t>(place) * length;
    const auto [low, high] = std::minmax_element(first, first + length);
    return *high - *low;
  }

  const PeriodMap& map_;
  std::vector<double> list_;
};

// Friction says nothing of a motion that slides: its state must come to rest.
bool still(const Periods& periods, const Deficits& deficits, const MapState& begin,
           const Period& period) {
  const Eigen::VectorXd change = periods.change(begin, period);
  return !period.events.empty() || change.size() == 0 ||
         change.cwiseAbs().maxCoeff() * deficits.slowness(1) <= periods.map().target();
}

}  // namespace

SteadyState plain_periods(Periods& periods, MapState state) {
  Deficits deficits(periods.map());
  for (std::size_t check = 12;; check += check / 4) {
    MapState begin;
    Period period;
    while (deficits.size() < check) {
      begin = state;
      period = periods.run(state);
      state = period.end;
      deficits.add(period.deficit);
    }
    const double left = deficits.trend();
    const bool at_rest = still(periods, deficits, begin, period);
    periods.note(
        at_rest
            ? fmt::format(": by its trend the friction ratio would still change by {:.1g}", left)
            : ": it slides all the time, but its state still moves");
    if (left > periods.map().target() || !at_rest) continue;
    const Period coarse = periods.run(begin, PeriodAccuracy::coarser);
    const double apart = std::abs(coarse.deficit - period.deficit);
    double error = caution * (apart + std::max(left, deficits.slowest_trend()));
    if (may_hide_stick(period, coarse, deficits.slowness(1))) error += missed_stick;
    return answer(std::move(period), error);
  }
}

}  // namespace vcrit::simulation::methods
