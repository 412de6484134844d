// What no sweep can be: axes, speeds and quantities that do not go together.
#pragma once

#include "sweep/sweep.hpp"

namespace vcrit {

/// Throw InputError: for an axis that the scene's settings fix, for none or several speeds or one
/// that is not above 0, and for two columns of one name.
void refuse_settings(const Sweep& sweep);
void refuse_speeds(const Sweep& sweep, const Grid& grid);
void refuse_repetition(const Sweep& sweep);

/// Whether it is of the value that a setting in the axis's place has.
bool is_of(const InputError& error, const Axis& axis);

/// Throws what is being handled, `error`, as a complaint of the axis whose value it is of: reading
/// says that it is of a setting, which nobody gave.
[[noreturn]] void refuse_as_of_axis(const Sweep& sweep, const InputError& error);

}  // namespace vcrit
