#include "sweep/refusals.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/speeds.hpp"
#include "scene/settings.hpp"

namespace vcrit {

void refuse_settings(const Sweep& sweep) {
  for (const auto& [name, value] : sweep.problem->source->settings)
    for (const Axis& axis : sweep.axes)
      if (axis.name == name)
        throw InputError(argument("over " + name), fmt::format("a setting of {} as well", name),
                         "one of the two");
}

void refuse_speeds(const Sweep& sweep, const Grid& grid) {
  const int speeds =
      (grid.speed() ? 1 : 0) + (sweep.velocity ? 1 : 0) + (sweep.velocity_ratio ? 1 : 0);
  if (speeds > 1 || (std::ranges::any_of(sweep.quantities, needs_motion) && speeds == 0))
    throw InputError({"sweep"}, speeds == 0 ? "a friction ratio at no speed" : "several speeds",
                     "velocity or velocity_ratio, as an axis (`over`) or as one value");
  if (grid.speed()) {
    const Axis& axis = grid.axes()[*grid.speed()];
    const Place place = argument("over " + axis.name);
    for (const double value : axis.values)
      if (axis.dimension == Dimension::none)
        check_speed_ratio(value, place);
      else
        check_speed(value, place);
  }
  if (sweep.velocity) check_speed(*sweep.velocity, argument("velocity"));
  if (sweep.velocity_ratio) check_speed_ratio(*sweep.velocity_ratio, argument("velocity_ratio"));
}

// Quantities and axes are columns of one table, variables of one file.
void refuse_repetition(const Sweep& sweep) {
  for (auto q = sweep.quantities.begin(); q != sweep.quantities.end(); ++q) {
    const std::string name = column_name(*q);
    if (std::find(sweep.quantities.begin(), q, *q) != q)
      throw InputError(argument("quantity"), name + " twice", "each quantity once");
    for (const Axis& axis : sweep.axes)
      if (axis.name == name)
        throw InputError(argument("over " + name), "an axis named like the quantity " + name,
                         "another name of this element in the scene");
  }
}

bool is_of(const InputError& error, const Axis& axis) {
  return error.place().argument == OverridingValues::place(axis.name).argument;
}

void refuse_as_of_axis(const Sweep& sweep, const InputError& error) {
  for (const Axis& axis : sweep.axes)
    if (is_of(error, axis))
      throw InputError(argument("over " + axis.name), error.found(), error.expected(),
                       error.advice());
  throw;
}

}  // namespace vcrit
