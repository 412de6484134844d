// The one-dimensional profile of an axisymmetric indenter f(r) in the method of dimensionality
// reduction (Popov and Hess, 2015),
//   g(x) = |x| int_0^|x| f'(r)/sqrt(x^2 - r^2) dr,
// whose contact with independent springs is that of f with a half-space.
#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace vcrit::indenter {

class Gap {
 public:
  /// Throws InputError for an indenter without its sizes or rows, ModelError where g falls by more
  /// than 1e-6 of itself: the contact would have holes.
  explicit Gap(const Indenter& indenter);

  /// g(x) in m; infinite beyond a punch or the last row of a table.
  double at(double x) const;

  /// The integral of g from 0 to x (m^2), which is not beyond the end.
  double area(double x) const;

  /// The largest x (m) with g(x) <= depth (m), at most the end of the indenter; 0 below the tip.
  double half_width(double depth) const;

  /// Of a punch or table, m; infinite for shapes that go on.
  double end() const { return end_; }

  /// Whether g = 0 all over.
  bool flat() const { return factor_ == 0 && radii_.empty(); }

  /// Radii (m) at which the slope of a table changes: g goes on from each like a square root.
  const std::vector<double>& edges() const { return radii_; }

 private:
  struct Parts {
    double rise = 0, fall = 0;  ///< both >= 0, g their difference
  };
  void set_power(double factor, double exponent);
  void set_table(const Profile& profile);
  Parts polygon(double x) const;
  Parts polygon_slope(double x) const;
  double highest_after(double highest, double low, double high) const;

  double end_;
  double factor_ = 0, exponent_ = 1;     ///< g = factor |x|^exponent
  std::vector<double> radii_, changes_;  ///< of a table: where its slope changes, and by what
  std::vector<double> at_radii_;         ///< the largest g up to each
};

}  // namespace vcrit::indenter
