// Stiffnesses and critical velocity of a scene over angular frequency, with what v* tends to and
// where the drive resonates.
#pragma once

#include <optional>

#include "compare/scene_report.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// From well below to well above the scene's own frequency and all its rates of relaxation and
/// resonances; over the table of a measured drive. Empty where the scene is known at one frequency
/// alone. Every value must be given.
FrequencyResponse frequency_response(const symbolic::Derivation& derivation);

}  // namespace vcrit::validation
