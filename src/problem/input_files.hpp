// What a problem was read from.
#pragma once

#include <filesystem>
#include <vector>

namespace vcrit {

class Problem;

/// The scene's file, and those of the tables that it names.
std::vector<std::filesystem::path> input_files(const Problem& problem);

}  // namespace vcrit
