// What the first screen of a scene's page says: the answer, its key numbers, and how sure it is.
#pragma once

#include "record/fields.hpp"
#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// Of the vibration, Hz.
double frequency_of(const SceneReport& report);

/// Amplitude, m, up to which the contact stays closed; none where it carries no load.
std::optional<double> closed_up_to(const SceneReport& report);

/// Of a report with an effect: `operating`, `keys`, `inputs`, `influences`, `left_out`, for
/// templates.
record::Json answer_record(const SceneReport& report);

}  // namespace vcrit::validation::report
