// Where the numbers of a motion, without dimensions, leave the range of doubles.
#pragma once

#include "base/errors.hpp"

namespace vcrit::simulation {

/// Throws ModelError unless `holds`.
inline void require_doubles(bool holds) {
  if (!holds)
    throw ModelError(
        "in units of the oscillation the numbers of this motion leave the range of doubles",
        "Eq. (24) needs none of them; for friction give values fewer orders of magnitude apart");
}

}  // namespace vcrit::simulation
