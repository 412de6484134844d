// Reading and writing whole files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vcrit {

/// The most bytes that are ever read of one file (512 MiB).
constexpr std::size_t largest_file = 1U << 29U;

/// Throws InputError naming the file, also for one of more than `largest` bytes or without end
/// (/dev/zero).
std::string read_file(const std::filesystem::path& file, std::size_t largest = largest_file);

struct NewFile {
  std::filesystem::path place;
  std::string text;
};

/// Creates missing folders, writes all files beside their places as NAME.part<PID>, and when all of
/// them are on the disk, renames them in this order, so that a reader sees old files or new ones.
/// Whatever cannot be written leaves the old ones, all of them, and no new folder. A symbolic link
/// at a place is replaced, not followed. Signals that would end the process wait until it is done.
/// Throws InputError naming the file.
void write_files(const std::vector<NewFile>& files);

/// Throws where write_files() is going to, as far as that is known before the work for the files is
/// done: no folder can be made, or nothing be put into it.
void check_folder(const std::filesystem::path& file);

/// One file in the same way.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace vcrit
