// The motion of an indenter on a drive that gives, where all touching cells slide for ever.
#pragma once

#include "indenter/rim.hpp"
#include "indenter/rim_motion.hpp"
#include "simulation/system/effort.hpp"

namespace vcrit::indenter {

/// A body sliding for ever below a drive at rest, and the numbers that its motion has at phase 0.
class Sliding {
 public:
  /// Of a body that swings freely at a harmonic the normal force alone is right. Both are kept by
  /// reference.
  Sliding(const ScaledContact& contact, const ScaledHolder& holder, double tolerance,
          SharedEffort* whole);

  const StateVector& body() const { return body_; }
  double mean_force() const;
  double mean_speed() const;
  double steps() const { return static_cast<double>(motion_.kept().size()); }

  /// The largest rate of u less velocity of the body while touching.
  double largest() const;

 private:
  StateVector after(const StateVector& body);
  void find();
  double rise(double t, const TimeStep& step) const;
  double largest_in(const TimeStep& step) const;

  RimMotion motion_;
  const ScaledContact& contact_;
  StateVector body_;
};

}  // namespace vcrit::indenter
