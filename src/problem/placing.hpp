// A scene as the parts of a problem, whose symbols know their places among its numbers.
#pragma once

#include "network/values.hpp"
#include "problem/problem.hpp"

namespace vcrit {

/// All symbols of a scene, also those without a number; of its elements the numbers (SI).
Values element_numbers(const Scene& scene);

/// The parts; `numbers`: as above. No network is reduced yet.
Resolved placed_parts(const Scene& scene, const Values& numbers);

}  // namespace vcrit
