// Reading and writing whole files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vcrit {

/// Throws InputError naming the file.
std::string read_file(const std::filesystem::path& file);

/// Creates missing folders, writes beside the place and renames, so that a reader sees the old file
/// or the new one. Throws InputError naming the file.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace vcrit
