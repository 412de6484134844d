#include "run/workers.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <system_error>

#include "base/errors.hpp"
#include "run/cleaner.hpp"
#include "run/system_failure.hpp"

namespace vcrit::validation {

namespace {

enum class MessageKind : char { step, answer, input_error, model_error, error };

/// What goes before each text in a pipe.
struct Head {
  MessageKind kind;
  std::uint64_t size;
};

void write_all(int pipe, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(pipe, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);  // nobody listens any more
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

void tell(int pipe, MessageKind kind, const std::string& text) {
  Head head{};
  head.kind = kind;
  head.size = text.size();
  char bytes[sizeof head];
  std::memcpy(bytes, &head, sizeof head);
  write_all(pipe, bytes, sizeof bytes);
  write_all(pipe, text.data(), text.size());
}

[[noreturn]] void serve(int pipe, const std::function<std::string(const Progress&)>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    tell(pipe, MessageKind::answer,
         work([&](const std::string& step) { tell(pipe, MessageKind::step, step); }));
  } catch (const InputError& error) {
    tell(pipe, MessageKind::input_error, error.what());
  } catch (const std::system_error& error) {
    tell(pipe, MessageKind::input_error, error.what());
  } catch (const ModelError& error) {
    tell(pipe, MessageKind::model_error, error.what());
  } catch (const std::exception& error) {
    tell(pipe, MessageKind::error, error.what());
  }
  _exit(0);
}

/// One running job; its process is ended with it.
class Worker {
 public:
  Worker(std::size_t job, const std::function<std::string(const Progress&)>& work) : job_(job) {
    int ends[2] = {};
    if (pipe2(ends, O_CLOEXEC) != 0) system_failure(errno, "pipe");
    process_ = fork();
    if (process_ < 0) system_failure(errno, "fork");
    if (process_ == 0) {
      close(ends[0]);
      serve(ends[1], work);
    }
    close(ends[1]);
    pipe_ = ends[0];
  }
  ~Worker() {
    close(pipe_);
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  std::size_t job() const { return job_; }
  int pipe_end() const { return pipe_; }
  const std::string& step() const { return step_; }

  /// Takes what has come. False at the end of the pipe.
  bool receive(const std::string& name) {
    std::array<char, 1 << 16> chunk{};
    const ssize_t size = read(pipe_, chunk.data(), chunk.size());
    if (size < 0 && errno == EINTR) return true;
    if (size <= 0) return false;
    received_.append(chunk.data(), static_cast<std::size_t>(size));
    while (take(name)) continue;
    return true;
  }

  /// The answer of a process that has ended; `in_place` as of in_processes().
  std::string ended(const std::string& name, const InPlace& in_place) {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    if (answer_) return *answer_;
    if (failure_.empty())
      failure_ = WIFSIGNALED(status)
                     ? fmt::format("its process was ended by signal {}", WTERMSIG(status))
                     : "its process ended without an answer";
    if (in_place) return in_place(job_, failure_);
    if (outside_model_) throw ModelError(failure_);
    throw std::runtime_error(name + ": " + failure_);
  }

 private:
  bool take(const std::string& name) {
    Head head{};
    if (received_.size() < sizeof head) return false;
    std::memcpy(&head, received_.data(), sizeof head);
    if (received_.size() - sizeof head < head.size) return false;
    const std::string text = received_.substr(sizeof head, head.size);
    received_.erase(0, sizeof head + head.size);
    if (head.kind == MessageKind::step) step_ = text;
    if (head.kind == MessageKind::answer) answer_ = text;
    if (head.kind == MessageKind::input_error) throw JobRefused(name + ": " + text);
    outside_model_ = head.kind == MessageKind::model_error;
    if (outside_model_ || head.kind == MessageKind::error) failure_ = text;
    return true;
  }

  std::size_t job_;
  int pipe_ = -1;
  pid_t process_ = 0;
  std::string received_, step_, failure_;
  bool outside_model_ = false;
  std::optional<std::string> answer_;
};

using Workers = std::vector<std::unique_ptr<Worker>>;

Standing standing(const Workers& workers, const std::vector<std::string>& names, std::size_t done) {
  Standing result{done, names.size(), {}};
  for (const auto& worker : workers)
    result.running.emplace_back(names[worker->job()], worker->step());
  return result;
}

/// Waits until one of them has something to say.
std::vector<bool> listen(const Workers& workers) {
  std::vector<pollfd> waiting;
  for (const auto& worker : workers) waiting.push_back({worker->pipe_end(), POLLIN, 0});
  while (poll(waiting.data(), waiting.size(), -1) < 0)
    if (errno != EINTR) system_failure(errno, "poll");
  std::vector<bool> ready;
  for (const pollfd& one : waiting) ready.push_back(one.revents != 0);
  return ready;
}

}  // namespace

std::vector<std::string> in_processes(
    const std::vector<std::string>& names, unsigned at_once,
    const std::function<std::string(std::size_t, const Progress&)>& work, const Watch& watch,
    const InPlace& in_place) {
  std::vector<std::string> answers(names.size());
  Cleaner::get();  // one for all of them
  Workers workers;
  for (std::size_t begun = 0, done = 0; done < names.size();) {
    for (; begun < names.size() && workers.size() < std::max(at_once, 1u); ++begun)
      workers.push_back(std::make_unique<Worker>(
          begun, [&, begun](const Progress& step) { return work(begun, step); }));
    const std::vector<bool> ready = listen(workers);
    for (std::size_t i = workers.size(); i-- > 0;) {
      if (!ready[i] || workers[i]->receive(names[workers[i]->job()])) continue;
      Worker& worker = *workers[i];
      answers[worker.job()] = worker.ended(names[worker.job()], in_place);
      workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(i));
      ++done;
    }
    watch(standing(workers, names, done));
  }
  return answers;
}

}  // namespace vcrit::validation
