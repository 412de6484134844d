#include "base/files.hpp"

#include <unistd.h>

#include <fstream>
#include <system_error>
#include <vector>

#include "base/errors.hpp"

namespace vcrit {

namespace fs = std::filesystem;

namespace {

// Stops at the first buffer beyond `largest`.
std::string read_up_to(std::ifstream& in, std::size_t largest) {
  std::string text;
  std::vector<char> buffer(1U << 16U);
  while (text.size() <= largest && in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

}  // namespace

std::string read_file(const fs::path& file, std::size_t largest) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file))
    throw InputError({file.string()}, "no readable file", "a file");
  std::string text = read_up_to(in, largest);
  if (in.bad()) throw InputError({file.string()}, "a read error", "a readable file");
  if (text.size() > largest)
    throw InputError({file.string()}, "more than " + std::to_string(largest) + " bytes",
                     "a file of at most so many");
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
