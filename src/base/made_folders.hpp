// Folders made for results, and gone again where no result came to lie in them.
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace vcrit {

class MadeFolders {
 public:
  MadeFolders() = default;
  /// Removes those of them that are empty.
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  /// Makes the missing ones above `file`, and returns what the system refused.
  std::error_code make_above(const std::filesystem::path& file);

 private:
  std::vector<std::filesystem::path> made_;  // each behind those above it
};

}  // namespace vcrit
