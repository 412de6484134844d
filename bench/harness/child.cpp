#include "harness/child.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <system_error>

namespace vcrit::bench {

namespace {

/// What the child writes into the pipe, in one piece.
struct Message {
  Ending ending;
  ChildNumbers numbers;
  char words[256];
};

// Processor time after which the system ends this process by SIGPROF; 0: never.
void limit_to(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

void confine(const Limits& limits) {
  limit_to(limits.time.count());
  if (!limits.of_programs) return;
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.time.count()));
  const rlimit time{seconds, seconds + 1}, memory{most_memory, most_memory};
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_AS, &memory);
}

void keep_memory() {
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  mallopt(M_MMAP_MAX, 0);
}

Message done(const std::function<ChildNumbers()>& work) {
  Message message{};
  try {
    message.numbers = work();
    message.ending = Ending::answered;
  } catch (const std::exception& error) {
    message.ending = Ending::refused;
    std::strncpy(message.words, error.what(), sizeof message.words - 1);
  }
  return message;
}

Report received(int pipe, pid_t child) {
  Message message{};
  const bool whole = read(pipe, &message, sizeof message) == sizeof message;
  int status = 0;
  waitpid(child, &status, 0);
  if (whole) return {message.ending, message.numbers, message.words};
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGPROF || signal == SIGXCPU) return {Ending::out_of_time, {}, "out of time"};
  return {Ending::crashed, {}, "crashed"};
}

}  // namespace

Report in_child(const Limits& limits, const std::function<ChildNumbers()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    keep_memory();
    confine(limits);
    const Message message = done(work);
    _exit(write(ends[1], &message, sizeof message) == sizeof message ? 0 : 1);
  }
  close(ends[1]);
  const Report report = received(ends[0], child);
  close(ends[0]);
  return report;
}

void lift_time_limit() { limit_to(0); }

}  // namespace vcrit::bench
