// One measurement in a process of its own, ended when its time or memory is used up: expanded
// forms may grow without end.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace vcrit::scaling {

/// What `seconds` returns, or nothing if it is not back in time, needs more than 12 GiB of
/// addresses, or fails.
std::optional<double> limited(const std::function<std::optional<double>()>& seconds,
                              std::chrono::seconds limit);

}  // namespace vcrit::scaling
