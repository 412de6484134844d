#include "base/output_places.hpp"

#include <system_error>

#include "base/errors.hpp"

namespace vcrit {

namespace fs = std::filesystem;

namespace {

// Also what a link leads to: /dev/stdout is one to a file below /proc.
bool is_no_file(const fs::path& place) {
  std::error_code error;
  if (fs::is_other(fs::status(place, error))) return true;
  return fs::is_symlink(fs::symlink_status(place, error)) &&
         fs::read_symlink(place, error).string().starts_with("/proc/");
}

}  // namespace

void check_place(const fs::path& place) {
  std::error_code error;
  if (fs::is_directory(fs::symlink_status(place, error)))
    throw InputError({place.string()}, std::make_error_code(std::errc::is_a_directory).message(),
                     "a place that can be written");
  if (is_no_file(place))
    throw InputError({place.string()}, "a device, a pipe or a socket",
                     "the name of a file, old or new");
}

void refuse_input_as_output(const fs::path& place, const std::vector<fs::path>& read) {
  for (const fs::path& each : read) {
    std::error_code error;
    if (fs::equivalent(place, each, error))
      throw InputError({place.string()}, "a file that this result is made from", "another name",
                       "it would be lost");
  }
}

}  // namespace vcrit
