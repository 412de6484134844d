// Speeds of the drive that a motion can be asked for.
#pragma once

#include <string>

#include "base/errors.hpp"

namespace vcrit {

/// Throws InputError, with `place`, for a speed (m/s) that is not finite or not above 0.
void check_speed(double velocity, const Place& place);

/// The same of a speed as a multiple of v*; `written`: a number as somebody typed it.
void check_speed_ratio(double ratio, const Place& place, const std::string& written = "");

}  // namespace vcrit
