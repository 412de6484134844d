#include "maps/part.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/errors.hpp"
#include "base/output_places.hpp"

namespace vcrit::maps {

namespace fs = std::filesystem;

namespace {

fs::path with_ending(fs::path file, const char* ending) { return file += ending; }

// Whether the open file still has its name: its last holder takes that away.
bool has_its_name(int descriptor, const fs::path& file) {
  struct stat open {
  }, named{};
  return fstat(descriptor, &open) == 0 && stat(file.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

// Nothing is written where a link leads.
const fs::path& without_link(const fs::path& part) {
  std::error_code error;
  if (fs::is_symlink(part, error))
    throw InputError({part.string()}, "a symbolic link", "a place of its own for the sweep");
  return part;
}

const fs::path& in_its_folder(const fs::path& part, MadeFolders& folders) {
  if (const auto error = folders.make_above(part)) refuse_part(part, error.message());
  return without_link(part);
}

// Before hours of work, not after.
const fs::path& checked_place(const fs::path& file) {
  check_place(file);
  return file;
}

}  // namespace

fs::path part_of(const fs::path& file) { return with_ending(file, ".part"); }

void refuse_part(const fs::path& part, const std::string& found, const std::string& next_step) {
  throw InputError({part.string()}, found, "a place that can be written", next_step);
}

PartFile::PartFile(const fs::path& file, bool resume)
    : file_(checked_place(file)), path_(part_of(file)), lock_(in_its_folder(path_, folders_)) {
  if (is_there() && !resume)
    throw InputError({path_.string()}, "an unfinished sweep",
                     "`resume` to go on with it, or that you remove it");
}

PartFile::Lock::Lock(const fs::path& part) : file_(with_ending(part, ".lock")) {
  while (true) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0) refuse_part(part, std::strerror(errno));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
      if (has_its_name(descriptor_, file_)) return;
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

PartFile::Lock::~Lock() {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

bool PartFile::is_there() const {
  std::error_code ignored;
  return fs::exists(path_, ignored);
}

void PartFile::put_into_place() {
  std::error_code error;
  fs::rename(path_, file_, error);
  if (error) refuse_part(path_, error.message());
}

void PartFile::remove() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace vcrit::maps
