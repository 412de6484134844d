#include "compiler.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <thread>

namespace vcrit::validation {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds compile_limit{120};
constexpr std::size_t most_output = 1 << 20;

void check(int error, const std::string& what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// In a folder, stdin empty, stdout and stderr to one file.
class Surroundings {
 public:
  Surroundings(const std::filesystem::path& folder, const std::filesystem::path& file) {
    check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, file.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions_, 1, 2);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  ~Surroundings() { posix_spawn_file_actions_destroy(&actions_); }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// A process group of its own, so that a compiler's children can be stopped with it.
class OwnGroup {
 public:
  OwnGroup() {
    check(posix_spawnattr_init(&attributes_), "posix_spawnattr_init");
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~OwnGroup() { posix_spawnattr_destroy(&attributes_); }
  OwnGroup(const OwnGroup&) = delete;
  OwnGroup& operator=(const OwnGroup&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const std::filesystem::path& output) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments)
    pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const Surroundings surroundings(folder, output);
  const OwnGroup group;
  pid_t process = 0;
  check(
      posix_spawn(&process, pointers[0], surroundings.get(), group.get(), pointers.data(), environ),
      arguments.front());
  return process;
}

/// Nothing while the process still runs.
std::optional<int> status_of(pid_t process, int options) {
  int status = 0;
  const pid_t ended = waitpid(process, &status, options);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
  if (ended < 0) throw std::system_error(errno, std::generic_category(), "waitpid");
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int stop(pid_t process) {
  kill(-process, SIGKILL);
  for (;;)
    if (const auto status = status_of(process, 0)) return *status;
}

std::string beginning_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(most_output, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

std::string_view search_path() {
  const char* path = std::getenv("PATH");
  return path == nullptr ? "" : path;
}

std::optional<std::filesystem::path> find_program(const std::string& name,
                                                  std::string_view search_path) {
  for (std::string_view rest = search_path; !rest.empty();) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    const std::filesystem::path program = std::filesystem::path(folder) / name;
    if (program.is_absolute() && access(program.c_str(), X_OK) == 0 &&
        std::filesystem::is_regular_file(program))
      return program;
  }
  return std::nullopt;
}

std::filesystem::path new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "vcrit-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "a folder like " + name);
  return name;
}

}  // namespace

PrivateFolder::PrivateFolder() : path_(new_folder()) {}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

ProgramResult run_program(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::milliseconds limit) {
  const std::filesystem::path output = folder / "output.txt";
  const pid_t process = start(arguments, folder, output);
  const auto deadline = Clock::now() + limit;
  ProgramResult result;
  for (;;) {
    if (const auto status = status_of(process, WNOHANG)) {
      result.status = *status;
      break;
    }
    if (Clock::now() >= deadline) {
      result.timed_out = true;
      result.status = stop(process);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  result.output = beginning_of(output);
  return result;
}

std::optional<std::filesystem::path> find_compiler(std::string_view search_path) {
  for (const char* name : {"g++", "clang++", "c++"})
    if (const auto program = find_program(name, search_path)) return program;
  return std::nullopt;
}

std::optional<std::filesystem::path> find_compiler() { return find_compiler(search_path()); }

std::optional<std::filesystem::path> find_program(const std::string& name) {
  return find_program(name, search_path());
}

ProgramResult compile(const std::filesystem::path& compiler, const std::filesystem::path& folder,
                      const std::string& source, const std::string& target) {
  return run_program(
      {compiler, "-std=c++20", "-O2", "-ffp-contract=off", "-o", folder / target, folder / source},
      folder, compile_limit);
}

std::string describe_compiler(const std::filesystem::path& compiler,
                              const std::filesystem::path& folder) {
  const ProgramResult result =
      run_program({compiler, "--version"}, folder, std::chrono::seconds(10));
  return result.output.substr(0, result.output.find('\n'));
}

}  // namespace vcrit::validation
