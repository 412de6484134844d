// Stiffnesses and critical velocity of a scene over angular frequency, with what v* tends to and
// where the drive resonates.
#pragma once

#include <optional>

#include "compare/scene_report.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// frequency_points() with the asymptotes of v*.
FrequencyResponse frequency_response(const symbolic::Derivation& derivation);

}  // namespace vcrit::validation
