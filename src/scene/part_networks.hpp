// What the networks of a scene's parts must be, once their numbers are known.
#pragma once

#include <functional>
#include <string>

#include "base/errors.hpp"
#include "network/network.hpp"

namespace vcrit {

/// Throws InputError at `place` for a drive with a mass between two moving points, and for one in
/// which only masses lead to the far end.
void refuse_misplaced_masses(const Network& drive, const Place& place);

/// Without the elements that are 0 where `zero` holds for symbols. Throws InputError where that
/// leaves no path of springs and dampers; `role`: "normal".
Network without_zeros(const Network& network, const std::function<bool(const Symbol&)>& zero,
                      const std::string& role, const std::string& file);

}  // namespace vcrit
