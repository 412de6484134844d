// An axis as it is drawn: its ends, where a value lies between them, and its ticks.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

struct Tick {
  double at = 0;
  std::string words;  ///< may be empty
};

class AxisScale {
 public:
  /// `shown`: what an axis without a range has to hold; values that have no place are left out.
  /// `count`: about how many ticks there is room for.
  AxisScale(const FigureAxis& axis, const std::vector<double>& shown, int count);

  /// 0 at the low end, 1 at the high one, beyond them outside; NaN for a value without a place.
  double place(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  bool logarithmic_;
  double low_, high_;  ///< of logarithms on a logarithmic axis
  std::vector<Tick> ticks_;
};

}  // namespace vcrit::validation::figures
