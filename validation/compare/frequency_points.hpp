// Stiffnesses and critical velocity of a scene over angular frequency, and where the drive
// resonates: numbers alone.
#pragma once

#include "compare/scene_report.hpp"

namespace vcrit::validation {

/// From well below to well above the scene's own frequency and all its rates of relaxation and
/// resonances; over the table of a measured drive. Empty where the scene is known at one frequency
/// alone. Every value must be given.
FrequencyResponse frequency_points(const Problem& problem);

}  // namespace vcrit::validation
