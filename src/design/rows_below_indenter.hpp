// Where the friction below an indenter is asked for. A state takes long there, so that there are
// few. On a compliant drive, v* takes as long as a state, so that no place is left out for it.
#pragma once

#include "design/range.hpp"

namespace vcrit::design {

/// Whether v* is no formula, but found for each value of what is sought.
bool finds_each_onset(const Problem& problem);

/// Each takes the ends of a range that is admissible, and gives it rows.
void add_amplitude_rows(const DesignQuestion& question, SearchRange& range);
void add_frequency_rows(const DesignQuestion& question, SearchRange& range);
void add_velocity_rows(const DesignQuestion& question, SearchRange& range);

/// A load (N) above which friction is closer to full than is asked for, at any speed.
double largest_force(const DesignQuestion& question, double least);

}  // namespace vcrit::design
