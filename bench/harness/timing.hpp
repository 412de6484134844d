// Processor time of one run of something, the same whatever was measured before.
#pragma once

#include <functional>

namespace vcrit::bench {

/// Of the calling thread, in seconds.
double processor_time();

/// Seconds that a run takes after those that came before it. `first` is what one took: long enough,
/// it is the answer. Else the median over batches that the clock can resolve, 5 to 51 of them, for
/// about `repeat` seconds.
double settled_time(const std::function<void()>& run, double first, double repeat);

/// The same of a run that was not yet made.
double settled_time(const std::function<void()>& run, double repeat);

}  // namespace vcrit::bench
