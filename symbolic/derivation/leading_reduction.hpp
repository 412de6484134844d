// What is left of a reduction when some elements grow or vanish.
#pragma once

#include <functional>

#include "network/reduction.hpp"

namespace vcrit::symbolic {

/// The reduction without the steps that do not contribute to the leading term in T of its result,
/// where an element goes with T^power. Nothing of a part that a limit lets go of is computed.
Reduction leading_reduction(const Reduction& reduction,
                            const std::function<int(const Element&)>& power);

}  // namespace vcrit::symbolic
