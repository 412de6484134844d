#include "run/compiler.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <thread>
#include <utility>

#include "run/cleaner.hpp"
#include "run/system_failure.hpp"

namespace vcrit::validation {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds compile_limit{120};  // only a compiler that hangs takes so long
// A program that waits for ever takes no processor time. On a machine that is busy with ten others
// one that works is given time to end.
constexpr int patience = 10;
// What a report can show of it is far less.
constexpr std::size_t most_output = 1 << 20;

constexpr const char* output_name = "output.txt";

/// What a child needs between fork and exec, made before: it may not allocate.
struct Command {
  Command(const std::vector<std::string>& words, const std::filesystem::path& in)
      : arguments(words), folder(in.string()), output((in / output_name).string()) {
    for (char** variable = environ; *variable != nullptr; ++variable)
      if (!std::string_view(*variable).starts_with("TMPDIR=")) environment.emplace_back(*variable);
    // What a compiler that is stopped leaves behind goes with the folder.
    environment.push_back("TMPDIR=" + folder);
  }

  std::vector<std::string> arguments, environment;
  std::string folder, output;
};

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

void limit_to(int resource, rlim_t most) {
  rlimit limit{};
  getrlimit(static_cast<__rlimit_resource>(resource), &limit);
  limit.rlim_cur = std::min(limit.rlim_max, most);
  limit.rlim_max = limit.rlim_cur;
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

bool set_streams(const Command& command) {
  const int empty = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int output = open(command.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  return dup2(empty, 0) == 0 && dup2(output, 1) == 1 && dup2(output, 2) == 2;
}

/// In a process group of its own, so that a compiler's children can be stopped with it. Returns
/// only when something went wrong, which errno tells.
void become(const Command& command, char* const* arguments, char* const* environment,
            std::chrono::seconds time, std::optional<std::uint64_t> memory) {
  setpgid(0, 0);
  Cleaner::get().watch(getpid());
  limit_to(RLIMIT_CPU, static_cast<rlim_t>(time.count()));
  if (memory) limit_to(RLIMIT_AS, *memory);
  limit_to(RLIMIT_FSIZE, largest_written_file);
  limit_to(RLIMIT_CORE, 0);
  close_range(STDERR_FILENO + 1, UINT_MAX, CLOSE_RANGE_CLOEXEC);
  if (set_streams(command) && chdir(command.folder.c_str()) == 0)
    execve(arguments[0], arguments, environment);
}

pid_t start(Command command, std::chrono::seconds time, std::optional<std::uint64_t> memory) {
  const std::vector<char*> arguments = pointers_to(command.arguments);
  const std::vector<char*> environment = pointers_to(command.environment);
  Cleaner::get();
  int ends[2] = {};
  if (pipe2(ends, O_CLOEXEC) != 0) system_failure(errno, "pipe");
  const pid_t process = fork();
  if (process == 0) {
    become(command, arguments.data(), environment.data(), time, memory);
    const int error = errno;
    _exit(write(ends[1], &error, sizeof error) == sizeof error ? 127 : 126);
  }
  const int fork_error = errno;
  close(ends[1]);
  int error = 0;
  // Nothing comes when exec has closed the pipe.
  const bool failed = process > 0 && read(ends[0], &error, sizeof error) == sizeof error;
  close(ends[0]);
  if (process < 0) system_failure(fork_error, "fork");
  if (!failed) return process;
  Cleaner::get().forget(process);
  waitpid(process, nullptr, 0);
  system_failure(error, command.arguments.front());
}

/// Whether it has ended; it is still there to be waited for.
bool has_ended(pid_t process) {
  siginfo_t information{};
  const int options = WEXITED | WNOHANG | WNOWAIT;
  if (waitid(P_PID, static_cast<id_t>(process), &information, options) != 0 && errno != EINTR)
    system_failure(errno, "waitid");
  return information.si_pid == process;
}

/// Its exit status, and the processor time that it and its children took, after all that it had
/// started is stopped. Its number belongs to nobody else before it is waited for.
std::pair<int, std::chrono::microseconds> end(pid_t process) {
  kill(-process, SIGKILL);
  Cleaner::get().forget(process);
  int status = 0;
  rusage used{};
  while (wait4(process, &status, 0, &used) < 0)
    if (errno != EINTR) system_failure(errno, "wait4");
  const auto time = [](const timeval& of) {
    return std::chrono::seconds(of.tv_sec) + std::chrono::microseconds(of.tv_usec);
  };
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
          time(used.ru_utime) + time(used.ru_stime)};
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

std::optional<std::filesystem::path> program_in(const std::string& name,
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
  std::string name = (Cleaner::get().folder() / "XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) system_failure(errno, "a folder like " + name);
  return name;
}

}  // namespace

PrivateFolder::PrivateFolder() : path_(new_folder()) {}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

ProgramResult run_program(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::milliseconds limit,
                          std::optional<std::uint64_t> memory) {
  const auto time = std::chrono::ceil<std::chrono::seconds>(limit);  // the system counts no finer
  const pid_t process = start(Command(arguments, folder), time, memory);
  const auto deadline = Clock::now() + patience * limit;
  ProgramResult result;
  while (!has_ended(process) && !result.timed_out) {
    result.timed_out = Clock::now() >= deadline;
    std::this_thread::sleep_for(std::chrono::milliseconds(result.timed_out ? 0 : 2));
  }
  const auto [status, used] = end(process);
  result.status = status;
  // What the system stops it by counts ticks: a few per cent more or less than it took.
  result.timed_out |= status != 0 && used >= 0.9 * time;
  result.output = beginning_of(folder / output_name);
  return result;
}

std::string failure_words(const ProgramResult& result, const char* what) {
  const char* how = result.timed_out ? "took too long" : "failed";
  return fmt::format("{} {}: {}", what, how, result.output.substr(0, 400));
}

std::optional<std::filesystem::path> find_compiler(std::string_view search_path) {
  for (const char* name : {"g++", "clang++", "c++"})
    if (const auto program = program_in(name, search_path)) return program;
  return std::nullopt;
}

std::optional<std::filesystem::path> find_compiler() { return find_compiler(search_path()); }

std::optional<std::filesystem::path> find_program(const std::string& name) {
  return program_in(name, search_path());
}

ProgramResult compile(const std::filesystem::path& compiler, const std::filesystem::path& folder,
                      const std::string& source, const std::string& target,
                      const std::vector<std::string>& flags) {
  std::vector<std::string> command{compiler, "-std=c++20"};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), {"-ffp-contract=off", "-o", folder / target, folder / source});
  return run_program(command, folder, compile_limit);
}

std::string describe_compiler(const std::filesystem::path& compiler,
                              const std::filesystem::path& folder) {
  const ProgramResult result =
      run_program({compiler, "--version"}, folder, std::chrono::seconds(10));
  return result.output.substr(0, result.output.find('\n'));
}

}  // namespace vcrit::validation
