// Reading and writing whole files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace vcrit {

/// The most bytes that are ever read of one file (512 MiB).
constexpr std::size_t largest_file = 1U << 29U;

/// Throws InputError naming the file, also for one of more than `largest` bytes or without end
/// (/dev/zero).
std::string read_file(const std::filesystem::path& file, std::size_t largest = largest_file);

/// Creates missing folders, writes beside the place and renames, so that a reader sees the old file
/// or the new one. Throws InputError naming the file.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace vcrit
