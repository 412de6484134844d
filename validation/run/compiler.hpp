// Programs started without a shell, in private folders: the generated evaluator is compiled and run
// the way a stranger would do it, and nothing of a scene is ever read by a shell.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vcrit::validation {

/// A new folder that only this user can enter, removed with all it holds at the end, also when this
/// process is killed.
class PrivateFolder {
 public:
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct ProgramResult {
  int status = 0;          ///< exit status; 128 + n after signal n
  bool timed_out = false;  ///< stopped, with all it had started, at the time limit
  std::string output;      ///< stdout and stderr as they came, at most the first megabyte
  bool succeeded() const { return status == 0 && !timed_out; }
};

/// Of a started program, in bytes: the address space, and each file that it writes.
inline constexpr std::uint64_t most_memory = 4ULL << 30, largest_written_file = 1ULL << 30;

/// Runs `arguments` (the program's path first) as they stand, without input, in `folder`, where its
/// output and its temporary files are kept meanwhile (both absolute). It is stopped when it, or a
/// process that it starts, has taken `limit` of processor time, or ten times that has passed: how
/// busy the machine is decides nothing. When it has ended, and when this process is killed, nothing
/// that it started runs on. Throws std::system_error if it cannot be started.
ProgramResult run_program(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::milliseconds limit,
                          std::optional<std::uint64_t> memory = most_memory);

/// How a program that did not succeed failed, with the beginning of what it wrote; `what` names it.
std::string failure_words(const ProgramResult& result, const char* what);

/// The program of that name in the first of the folders of PATH that has one; folders of PATH that
/// are not absolute are passed over.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// The first C++ compiler on `search_path` (folders separated by ':', as in PATH).
std::optional<std::filesystem::path> find_compiler(std::string_view search_path);
/// The same with this process's PATH.
std::optional<std::filesystem::path> find_compiler();

/// Compiles one C++20 source in `folder` to the program `target` there. Nothing is contracted, so
/// that values do not change with the processor that `flags` name.
ProgramResult compile(const std::filesystem::path& compiler, const std::filesystem::path& folder,
                      const std::string& source, const std::string& target,
                      const std::vector<std::string>& flags);

/// "g++ (Debian 12.2.0-14) 12.2.0": the first line of what it says of itself.
std::string describe_compiler(const std::filesystem::path& compiler,
                              const std::filesystem::path& folder);

}  // namespace vcrit::validation
