// An indenter on a drive that gives, in units in which friction below it has few numbers.
// Time is omega t; normal lengths are in du_z, tangential ones in kappa du_z with kappa = mu0
// E*/G*, and forces in the largest normal force, tangential ones in mu0 times it. mu0 drops out.
//
// With the indentation u and the position y of the body, a cell that slides forward (d = 1) or
// backward (d = -1) has the tangential deformation d (u - g): its velocity of sliding is that of
// the level l_d = y - d u, the same for all cells. A cell that stuck when the level was l has the
// force f - (l - l_+) or -f + (l_- - l), of its normal force f and the levels of now. So a cell
// remembers one level, and cells that touch the surface at the depth g(x) form a continuum whose
// levels are layers over that depth: one level for all that stuck at once, and a level for each
// that has touched since. Only a rim slides, of all cells from one depth on (docs/physics.md).
#pragma once

#include <memory>
#include <vector>

#include "indenter/half_space.hpp"
#include "indenter/memory_force.hpp"

namespace vcrit::indenter {

/// The contact in these units.
class ScaledContact {
 public:
  /// Of no flat punch. tolerance: relative, of the force of a half-space that is not elastic.
  ScaledContact(const HalfSpace& half_space, double tolerance);

  double depth(double t) const;  ///< u; below 0 while the indenter is off the surface
  double depth_rate(double t) const;
  /// Stiffness of all cells that touch at this depth or less, of an elastic half-space.
  double stiffness(double depth) const;
  /// All of it at a time.
  struct Moment {
    double t, depth, depth_rate;
    double stiffness;   ///< of all cells that touch
    double force;       ///< F_n
    double force_rate;  ///< as far as it is bounded
  };
  Moment at(double t) const;
  /// Depth and its rate alone, the rest 0.
  Moment depths_at(double t) const { return {t, depth(t), depth_rate(t), 0, 0, 0}; }
  /// Whether F_n' is not: then only a body or a damper keeps v* finite.
  bool force_rate_unbounded() const { return memory_ && memory_->rate_unbounded(); }
  bool touches(double t) const;
  /// Where depth, stiffness or force turn sharply, in [0, 2 pi], increasing.
  const std::vector<double>& kinks() const { return kinks_; }

  double speed_unit() const { return speed_unit_; }  ///< m/s
  double force_unit() const { return force_unit_; }  ///< N, of normal forces
  /// N/m, of drives
  double stiffness_unit() const { return stiffness_unit_; }

 private:
  double stiffness_of(double edge) const;
  double physical_force(double depth) const;

  Gap gap_;
  double amplitude_, modulus_, mean_;
  double force_unit_ = 1, speed_unit_ = 1, stiffness_unit_ = 1;
  std::vector<double> kinks_;
  std::shared_ptr<const MemoryForce> memory_;  ///< none of an elastic half-space
};

/// What holds it: a spring, a damper and relaxing springs side by side, and a mass.
struct ScaledHolder {
  ScaledHolder(const HalfSpace& half_space, const ScaledContact& contact);

  double spring = 0, damper = 0, mass = 0;
  std::vector<MaxwellBranch> branches;

  double glassy() const;  ///< of all springs
};

}  // namespace vcrit::indenter
