// Units that scenes are full of, by their powers of ten. udunits knows these and all others, but
// reads its database first, which takes longer than an evaluation of v*.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/units.hpp"

namespace vcrit {

struct TabledUnit {
  Dimension dimension;
  std::string_view name;
  int power;  ///< of ten: a number of this unit times that is a number of the SI unit
};
std::span<const TabledUnit> tabled_units();

/// 6 of "N/um", a stiffness. Nothing for a unit that is not in the table, or is one of another
/// dimension.
std::optional<int> usual_power(std::string_view unit, Dimension dimension);

}  // namespace vcrit
