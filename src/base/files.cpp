#include "base/files.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "base/errors.hpp"

namespace vcrit {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file))
    throw InputError({file.string()}, "no readable file", "a file");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError({file.string()}, "a read error", "a readable file");
  return text;
}

void write_file(const fs::path& file, std::string_view text) {
  const auto refuse = [&](const std::string& found) {
    throw InputError({file.string()}, found, "a place that can be written");
  };
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) refuse(error.message());
  fs::path beside = file;
  beside += ".part" + std::to_string(::getpid());
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  if (out) fs::rename(beside, file, error);
  if (!out || error) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    refuse(error ? error.message() : "no room or no permission");
  }
}

}  // namespace vcrit
