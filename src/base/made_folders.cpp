#include "base/made_folders.hpp"

#include <unistd.h>

namespace vcrit {

namespace fs = std::filesystem;

std::error_code MadeFolders::make_above(const fs::path& file) {
  fs::path folder;
  for (const fs::path& name : file.parent_path()) {
    folder /= name;
    std::error_code error;
    if (fs::is_directory(folder, error)) continue;
    // Another process may be as fast.
    if (!fs::create_directory(folder, error) && !error) continue;
    if (error == std::errc::file_exists) return make_error_code(std::errc::not_a_directory);
    if (error) return error;
    made_.push_back(folder);
  }
  return {};
}

// rmdir refuses a folder that has something in it, whoever put it there.
MadeFolders::~MadeFolders() {
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
}

}  // namespace vcrit
