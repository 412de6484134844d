// Accuracy, cost and stability of everything that computes v* or friction of one scene.
#pragma once

#include "accuracy/data.hpp"
#include "agreement.hpp"
#include "scene/scene.hpp"

namespace vcrit::validation::accuracy {

/// Takes some seconds, most of it simulation. Errors against run time depend on the machine; inputs
/// and values do not. Throws InputError for missing values.
Accuracy measure(const Scene& scene, const Progress& progress);

}  // namespace vcrit::validation::accuracy
