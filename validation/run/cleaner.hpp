// A process that does nothing but wait for the end of this one, however it comes (SIGKILL, too),
// and then stops the programs that were started and removes the temporary folders.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace vcrit::validation {

class Cleaner {
 public:
  /// This process's, begun at the first call, or its parent's where it was forked after that.
  /// Throws std::system_error.
  static const Cleaner& get();

  /// A folder that only this user can enter, in that for temporary files. All that is in it is
  /// removed when this process and all that were forked from it have ended.
  const std::filesystem::path& folder() const { return folder_; }

  /// From now on, and until it is forgotten, this group of processes is stopped in the end. They
  /// may be called between fork and exec.
  void watch(pid_t group) const;
  void forget(pid_t group) const;

  Cleaner(const Cleaner&) = delete;
  Cleaner& operator=(const Cleaner&) = delete;

 private:
  Cleaner();
  ~Cleaner();

  int line_ = -1;
  pid_t process_ = 0, owner_ = 0;
  std::filesystem::path folder_;
};

}  // namespace vcrit::validation
