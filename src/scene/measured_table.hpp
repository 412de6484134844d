// Reads the table of a contact that was measured (measured_stiffness.hpp).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/errors.hpp"
#include "scene/measured_stiffness.hpp"

namespace vcrit {

/// Reads a table as `vcrit fit` takes it; its notes go to `notes`. Throws InputError with file and
/// line, also for a row that no passive contact has: a storage stiffness of 0 or a loss below 0. At
/// `place` where there is no such file.
std::shared_ptr<const StiffnessTable> read_measured_stiffness(const std::string& file,
                                                              const Place& place,
                                                              std::vector<Warning>& notes);

}  // namespace vcrit
