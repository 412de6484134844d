#include "maps/part_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/errors.hpp"

namespace vcrit::maps {

namespace {

// Whether the open file still has its name: its last holder takes that away.
bool is_there(int descriptor, const std::filesystem::path& file) {
  struct stat open {
  }, named{};
  return fstat(descriptor, &open) == 0 && stat(file.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace

PartLock::PartLock(const std::filesystem::path& part) : file_(part) {
  file_ += ".lock";
  std::error_code ignored;
  if (part.has_parent_path()) std::filesystem::create_directories(part.parent_path(), ignored);
  while (true) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0)
      throw InputError({part.string()}, std::strerror(errno), "a place that can be written");
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
      if (is_there(descriptor_, file_)) return;
      ::close(descriptor_);
      continue;
    }
    const bool held = errno == EWOULDBLOCK;
    ::close(descriptor_);
    descriptor_ = -1;
    if (!held) return;
    throw InputError({part.string()}, "a sweep that is running now",
                     "another place for this one, or that it waits for the other's end");
  }
}

PartLock::~PartLock() {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace vcrit::maps
