#include "benchmark/limited_run.hpp"

#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <system_error>
#include <vector>

namespace vcrit::benchmark {

namespace {

/// What the child writes into the pipe, in one piece.
struct Message {
  Ending ending;
  Answer answer;
  double seconds;
  char words[256];
};

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double time_of(const std::function<Answer()>& solve, int times) {
  const double begin = processor_time();
  for (int i = 0; i < times; ++i) solve();
  return (processor_time() - begin) / times;
}

// Short solves in batches that the clock can resolve, for 5 to 51 of them.
double median_time(const std::function<Answer()>& solve, double first, double repeat) {
  if (4 * first > repeat) return first;
  const int batch = static_cast<int>(std::clamp(2e-4 / first, 1.0, 1000.0));
  const int count = static_cast<int>(std::clamp(repeat / (batch * first), 5.0, 51.0));
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(time_of(solve, batch));
  std::nth_element(times.begin(), times.begin() + count / 2, times.end());
  return times[static_cast<std::size_t>(count / 2)];
}

// Processor time after which the system ends this process by SIGPROF; 0: never.
void limit_to(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

Message solved(const std::function<Answer()>& solve, double budget, double repeat) {
  Message message{};
  try {
    limit_to(budget);
    const double begin = processor_time();
    message.answer = solve();
    const double first = processor_time() - begin;
    limit_to(0);
    message.seconds = median_time(solve, first, repeat);
    message.ending = Ending::answered;
  } catch (const std::exception& error) {
    message.ending = Ending::refused;
    std::strncpy(message.words, error.what(), sizeof message.words - 1);
  }
  return message;
}

Run received(int pipe, pid_t child) {
  Message message{};
  const bool whole = read(pipe, &message, sizeof message) == sizeof message;
  int status = 0;
  waitpid(child, &status, 0);
  if (whole) return {message.ending, message.answer, message.seconds, message.words};
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
    return {Ending::out_of_time, {}, 0, "out of time"};
  return {Ending::crashed, {}, 0, "crashed"};
}

}  // namespace

Run run_limited(const std::function<Answer()>& solve, std::chrono::duration<double> budget,
                std::chrono::duration<double> repeat) {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    const Message message = solved(solve, budget.count(), repeat.count());
    _exit(write(ends[1], &message, sizeof message) == sizeof message ? 0 : 1);
  }
  close(ends[1]);
  const Run run = received(ends[0], child);
  close(ends[0]);
  return run;
}

}  // namespace vcrit::benchmark
