// Ways to K(s) in symbols: ours, and those one would take with GiNaC, FLINT, SymPy and Maxima.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scaling/families.hpp"

namespace vcrit::scaling {

/// Seconds of one derivation; nothing for a network not of its kind.
struct ScalingPeer {
  std::string name;
  std::function<std::optional<double>(const ScalingCase&)> seconds;
};

/// Nested: every inner quantity named, nothing multiplied out.
std::vector<ScalingPeer> nested_peers();
/// One numerator over one denominator.
std::vector<ScalingPeer> expanded_peers();

/// Seconds of v* derived from a scene with the case as its contact, K named as above.
double whole_derivation(const ScalingCase& each);
/// Seconds of all limits, and all sensitivities, of that derivation.
double all_limits(const ScalingCase& each);
double all_sensitivities(const ScalingCase& each);

/// Of a run when it is repeated for a tenth of a second, or of the only one.
double seconds_of(const std::function<void()>& run);

}  // namespace vcrit::scaling
