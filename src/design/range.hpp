// What of an amplitude, a frequency or a speed is worth asking for, and in which order.
#pragma once

#include <optional>
#include <vector>

#include "design/opening.hpp"
#include "design/solve.hpp"
#include "design/stretches.hpp"

namespace vcrit::design {

struct SearchRange {
  double from = 0, to = 0;  ///< asked for and admissible, in the unit of what is sought
  /// Rows of places in that unit, each searched for itself, in the order of preference. None where
  /// friction is full throughout.
  std::vector<std::vector<double>> rows;
  /// The largest drive velocity with an effect in the range (m/s) and where. For a speed, the end
  /// of the range itself.
  double largest_velocity = 0, largest_at = 0;
  bool monotonic = false;  ///< friction never falls from the last place of a row to the first
  /// The ratio as the speed vanishes, where it is asked for and known: none falls below it.
  std::optional<double> at_rest{};
};

/// Throws InputError for an empty range, ModelError where nothing in it is admissible.
SearchRange range_of(const DesignQuestion& question, const NormalContact& contact);

}  // namespace vcrit::design
