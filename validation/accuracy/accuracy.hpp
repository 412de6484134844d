// Accuracy, cost and stability of everything that computes v* or friction of one scene.
#pragma once

#include "accuracy/data.hpp"
#include "run/driver.hpp"
#include "run/progress.hpp"

namespace vcrit::validation::accuracy {

/// Takes some seconds, most of it simulation, and compiles the driver if that is not yet
/// done. Errors against run time depend on the machine; inputs
/// and values do not. Throws InputError for missing values.
Accuracy measure(Driver& driver, const Progress& progress);

}  // namespace vcrit::validation::accuracy
