// Generated files on the disk.
#pragma once

#include <vector>

#include "base/files.hpp"

namespace vcrit::symbolic {

/// All of them or none (base/files.hpp), in place of files that vcrit generated before. Throws
/// InputError where one of another hand stands in a place.
void write_generated(const std::vector<NewFile>& files);

}  // namespace vcrit::symbolic
