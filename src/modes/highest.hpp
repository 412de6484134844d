// The largest value of an event function over an interval, by the same proof by which no event is
// missed (first_zero.hpp): from each point on it is shown how long the function stays below the
// highest value found so far; where that cannot be shown, the way leads uphill.
#pragma once

#include "modes/event_function.hpp"

namespace vcrit::simulation {

/// The largest f(t), 0 <= t <= end, to within its rounding error. Throws ModelError where f
/// oscillates too often, or its effort is spent.
double highest(EventFunction& f, double end);

}  // namespace vcrit::simulation
