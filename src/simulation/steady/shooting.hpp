// Newton's method on a cycle's state and events together, along a known course. An event nearly
// tangential, at which the period map bends sharply, is one more smooth equation here.
#pragma once

#include "simulation/motion/course.hpp"

namespace vcrit::simulation {

/// A state in the middle of the closed cycle's first slip. Nothing where it does not converge; that
/// the cycle keeps to the law of friction on the way is to be proved.
std::optional<State> shoot(const Model& model, double velocity, Course course);

}  // namespace vcrit::simulation
