// How deep the contact is pressed on the mean: as the scene says, or as its load has it. Where the
// contact stays closed u_z0 = W/K_n(0); where it opens, and below an indenter, the mean normal
// force grows with u_z0 from 0, at u_z0 = -du_z, with a slope above 0 and up to K_n(0)
// (docs/physics.md), so that there is one u_z0 for every load. It may be negative. Below a mount it
// is the body's, the mean of what the mount leaves of the vibrator's.
#pragma once

#include <functional>

#include "normal/normal_motion.hpp"
#include "problem/problem.hpp"

namespace vcrit::simulation {

/// u_z0, m: for all who would know it. Found once for all copies of a problem. Throws InputError
/// for missing values, ModelError where the mean normal force is not found; infinite under a load
/// that no spring carries.
double mean_indentation(const Problem& problem);

/// What a contact that opens is pressed by. Below a mount without mass that is the vibrator, which
/// presses mount and contact in series: with no force but theirs, their deformations together are
/// at least what it prescribes, and more where the surfaces part. Throws as mean_indentation()
/// does.
NormalMotion opening_motion(const Problem& problem);

/// <F_n> (N) while the contact stays closed: the load, or K_n(0) u_z0 with K_n(0) in N/m.
double closed_mean_force(const Problem& problem, double static_stiffness);

/// A mean normal force, and how it grows with the mean indentation.
struct PressedForce {
  double force = 0;  ///< N
  double slope = 0;  ///< N/m
};

/// The u (m) at which force(u) is the load (N): `low` (0 there) < u <= `high`, by Newton's method
/// from above with bisection as its guard. Near `low` forces grow like a power of about 3/2.
double pressed_by(const std::function<PressedForce(double)>& force, double load, double low,
                  double high);

/// Relative accuracy of the roots, far below that of the cycles.
inline constexpr double last_step = 1e-10;

/// What one search may cost, half a minute (base/effort.hpp).
inline constexpr std::size_t effort_of_pressing = 2'000'000'000;

}  // namespace vcrit::simulation
