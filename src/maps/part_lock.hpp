// One sweep at a time writes a part: of several that begin, or go on, at one moment exactly one
// does.
#pragma once

#include <filesystem>

namespace vcrit::maps {

/// Held by an advisory lock on OUT.part.lock, which the system lets go however the program ends.
class PartLock {
 public:
  /// Throws InputError where another sweep holds it.
  explicit PartLock(const std::filesystem::path& part);
  ~PartLock();
  PartLock(const PartLock&) = delete;
  PartLock& operator=(const PartLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;  // negative where the place knows no locks
};

}  // namespace vcrit::maps
