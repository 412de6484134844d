#include "scaling/limited.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <system_error>

namespace vcrit::scaling {

namespace {

void confine(std::chrono::seconds limit) {
  const auto seconds = static_cast<rlim_t>(limit.count());
  const rlimit time{seconds, seconds + 1}, memory{rlim_t{12} << 30, rlim_t{12} << 30};
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_AS, &memory);
}

// In the child: the answer's bytes go through the pipe, or none.
[[noreturn]] void answer(int pipe, const std::function<std::optional<double>()>& seconds) {
  bool written = false;
  try {
    if (const std::optional<double> result = seconds())
      written = write(pipe, &*result, sizeof *result) == sizeof *result;
  } catch (const std::exception&) {
    written = false;
  }
  _exit(written ? 0 : 1);
}

}  // namespace

std::optional<double> limited(const std::function<std::optional<double>()>& seconds,
                              std::chrono::seconds limit) {
  int ends[2] = {};
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    confine(limit);
    answer(ends[1], seconds);
  }
  close(ends[1]);
  double result = 0;
  const bool answered = read(ends[0], &result, sizeof result) == sizeof result;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return answered ? std::optional(result) : std::nullopt;
}

}  // namespace vcrit::scaling
