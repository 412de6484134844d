// Real roots of the secular functions of spring-damper networks,
//   f(x) = slope x - constant + sum_j weight_j/(x - pole_j),   x = -s a decay rate,
// each as an offset from the nearest pole, so that differences between roots and poles keep their
// relative accuracy however many decades the poles span. With slope 0 these are the retardation
// rates of a network; with slope m the real decay rates of a body of mass m held by one.
#pragma once

#include <cstddef>
#include <vector>

namespace vcrit {

struct SecularFunction {
  double slope = 0;             ///< >= 0
  double constant = 0;          ///< >= 0
  std::vector<double> poles;    ///< >= 0, increasing, all different
  std::vector<double> weights;  ///< > 0
};

/// A rate near a reference (a pole, or 0).
struct OffsetRate {
  double reference = 0;
  double offset = 0;

  double value() const { return reference + offset; }
  /// rate - pole: relatively accurate where the reference is the pole nearest to the rate.
  double minus(double pole) const { return (reference - pole) + offset; }
  double minus(const OffsetRate& other) const {
    return (reference - other.reference) + (offset - other.offset);
  }
};

/// All real roots x > 0, increasing. f is split into monotone pieces first, so none is missed; a
/// double root counts as two or none, as rounding decides. Throws InputError for missing weights.
std::vector<OffsetRate> positive_roots(const SecularFunction& f);

}  // namespace vcrit
