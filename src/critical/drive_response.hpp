// The drive's dynamic stiffness in balls, as a quotient K_d = force/deflection of which both sides
// are finite: a drive with masses has frequencies at which it does not give at all (it absorbs the
// body's motion) and others at which it gives without force.
#pragma once

#include <memory>

#include "critical/balls.hpp"
#include "problem/problem.hpp"

namespace vcrit {

struct DriveResponse {
  Ball force, deflection;
};

class DriveInBalls {
 public:
  DriveInBalls() = default;
  DriveInBalls(const DriveInBalls&) = delete;
  DriveInBalls& operator=(const DriveInBalls&) = delete;
  virtual ~DriveInBalls() = default;
  virtual DriveResponse at(Balls& balls) const = 0;
  /// Operations on doubles in it, which bounds the digits of the two quantities.
  virtual std::size_t steps() const = 0;
};

/// The drive of a scene that has one. Throws ModelError where nothing is known of it at the scene's
/// frequency.
std::unique_ptr<const DriveInBalls> drive_in_balls(const Problem& problem);

}  // namespace vcrit
