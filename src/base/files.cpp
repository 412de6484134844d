#include "base/files.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/identifiers.hpp"
#include "base/made_folders.hpp"
#include "base/output_places.hpp"

namespace vcrit {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& file, const std::error_code& error) {
  throw InputError({file.string()}, error.message(), "a place that can be written");
}

[[noreturn]] void refuse(const fs::path& file) {
  refuse(file, {errno == 0 ? EIO : errno, std::generic_category()});
}

/// Ctrl-C and its like come after the last rename, not between two.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_{};
};

/// A file beside its place, removed unless it was put there.
class Part {
 public:
  explicit Part(fs::path place) : place_(std::move(place)) {
    // A new file: neither what somebody has put there, nor where a link of theirs leads.
    constexpr int tries = 100;
    for (int i = 0; i < tries && file_ < 0; ++i) {
      part_ = place_;
      part_ += ".part" + std::to_string(::getpid()) + (i == 0 ? "" : "-" + std::to_string(i));
      file_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
      if (file_ < 0 && errno != EEXIST) break;
    }
    if (file_ < 0) refuse(place_);
  }
  Part(Part&& other) noexcept
      : place_(std::move(other.place_)),
        part_(std::exchange(other.part_, {})),
        file_(std::exchange(other.file_, -1)) {}
  Part& operator=(Part&&) = delete;
  ~Part() {
    if (file_ >= 0) ::close(file_);
    if (!part_.empty()) ::unlink(part_.c_str());
  }

  /// All of it on the disk: a file of that name will be whole even after a loss of power.
  void fill(std::string_view text) {
    while (!text.empty()) {
      const ssize_t size = ::write(file_, text.data(), text.size());
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) refuse(place_);
      text.remove_prefix(static_cast<std::size_t>(size));
    }
    // Not every kind of file can be synchronised.
    if (::fsync(file_) != 0 && errno != EINVAL && errno != ENOTSUP) refuse(place_);
    if (::close(std::exchange(file_, -1)) != 0) refuse(place_);
  }

  void put_into_place() {
    if (std::rename(part_.c_str(), place_.c_str()) != 0) refuse(place_);
    part_.clear();
  }

 private:
  fs::path place_, part_;
  int file_ = -1;
};

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

// More than these in one folder are not looked through for the sake of a message.
constexpr int most_names_compared = 10000;

/// The file beside it that is called most alike and ends alike, or in any way where `file` has no
/// ending; empty where none is.
fs::path nearest_file(const fs::path& file) {
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::map<std::string, fs::path> names;  // by their stems; folders have no order
  int left = most_names_compared;
  for (fs::directory_iterator each(folder, error), end; !error && each != end && left-- > 0;
       each.increment(error)) {
    const fs::path name = each->path().filename();
    if (name == file.filename()) continue;  // a link to nowhere
    if (file.extension().empty() || name.extension() == file.extension())
      names.emplace(name.stem().string(), name);
  }
  std::vector<std::string> stems;
  for (const auto& [stem, name] : names) stems.push_back(stem);
  const auto meant = nearest(file.stem().string(), stems);
  return meant ? file.parent_path() / names.at(*meant) : fs::path();
}

[[noreturn]] void refuse_missing(const fs::path& file) {
  const fs::path meant = nearest_file(file);
  throw InputError({file.string()}, "no such file", "a file that can be read",
                   meant.empty() ? "" : "did you mean " + meant.string() + "?");
}

}  // namespace

std::string read_file(const fs::path& file, std::size_t largest) {
  std::error_code error;
  if (fs::status(file, error).type() == fs::file_type::not_found) refuse_missing(file);
  if (fs::is_directory(file, error)) throw InputError({file.string()}, "a folder", "a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError({file.string()}, "a file that cannot be read", "one that can");
  std::string text = read_up_to(in, largest);
  if (in.bad()) throw InputError({file.string()}, "a read error", "a readable file");
  if (text.size() > largest)
    throw InputError({file.string()}, "more than " + std::to_string(largest) + " bytes",
                     "a file of at most so many");
  return text;
}

void write_files(const std::vector<NewFile>& files) {
  const SignalsWait wait;
  MadeFolders folders;  // outlive the parts in them
  std::vector<Part> parts;
  for (const NewFile& file : files) {
    // What is in the way would be found by the renames, too late for the files before it.
    check_place(file.place);
    if (const auto error = folders.make_above(file.place)) refuse(file.place, error);
    parts.emplace_back(file.place).fill(file.text);
  }
  for (Part& part : parts) part.put_into_place();
}

void check_folder(const fs::path& file) {
  MadeFolders folders;
  if (const auto error = folders.make_above(file)) refuse(file, error);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) refuse(file);
}

void write_file(const fs::path& file, std::string_view text) {
  write_files({{file, std::string(text)}});
}

}  // namespace vcrit
