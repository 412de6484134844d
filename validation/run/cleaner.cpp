#include "run/cleaner.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <set>
#include <string>
#include <system_error>

#include "run/system_failure.hpp"

namespace vcrit::validation {

namespace {

/// Sent to the cleaner.
struct Message {
  pid_t group;
  bool watched;
};

/// What the cleaner answers when it has made the folder.
struct Made {
  int error;
  std::array<char, PATH_MAX> path;
};

/// Ctrl-C goes to all processes of a terminal, and nobody may wait for the end of our outputs.
void stand_aside(int line) {
  setsid();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
  dup2(line, STDERR_FILENO + 1);
  close_range(STDERR_FILENO + 2, UINT_MAX, 0);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    close(stream);
    if (open("/dev/null", O_RDWR) < 0) _exit(1);
  }
}

std::set<pid_t> listen_to_the_end(int line) {
  std::set<pid_t> groups;
  for (Message message{};;) {
    const ssize_t size = recv(line, &message, sizeof message, 0);
    if (size < 0 && errno == EINTR) continue;
    if (size != sizeof message) return groups;
    if (message.watched)
      groups.insert(message.group);
    else
      groups.erase(message.group);
  }
}

[[noreturn]] void clean(int socket, const std::string& pattern) {
  stand_aside(socket);
  const int line = STDERR_FILENO + 1;
  std::string folder = pattern;
  Made made{};
  if (mkdtemp(folder.data()) == nullptr) made.error = errno;
  folder.copy(made.path.data(), made.path.size() - 1);
  send(line, &made, sizeof made, MSG_NOSIGNAL);
  if (made.error != 0) _exit(1);
  for (const pid_t group : listen_to_the_end(line)) kill(-group, SIGKILL);
  std::error_code error;
  // Those that were stopped may still have been writing.
  for (int tries = 0; tries < 100; ++tries) {
    std::filesystem::remove_all(folder, error);
    if (!error) break;
    usleep(10'000);
  }
  _exit(0);
}

}  // namespace

const Cleaner& Cleaner::get() {
  static const Cleaner cleaner;
  return cleaner;
}

Cleaner::Cleaner() : owner_(getpid()) {
  const char* chosen = std::getenv("TMPDIR");
  const std::filesystem::path all = chosen == nullptr || *chosen == '\0' ? "/tmp" : chosen;
  const std::string pattern = (std::filesystem::absolute(all) / "vcrit-XXXXXX").string();
  int ends[2] = {};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
    system_failure(errno, "socketpair");
  process_ = fork();
  if (process_ < 0) system_failure(errno, "fork");
  if (process_ == 0) clean(ends[1], pattern);
  close(ends[1]);
  line_ = ends[0];
  Made made{};
  ssize_t size = 0;
  do size = recv(line_, &made, sizeof made, 0);
  while (size < 0 && errno == EINTR);
  if (size != sizeof made || made.error != 0) {
    close(line_);
    waitpid(process_, nullptr, 0);
    system_failure(size == sizeof made ? made.error : EPIPE, "a folder like " + pattern);
  }
  folder_ = made.path.data();
}

/// Whoever begun it waits, so that nothing is left when the program has ended.
Cleaner::~Cleaner() {
  close(line_);
  if (getpid() == owner_) waitpid(process_, nullptr, 0);
}

void Cleaner::watch(pid_t group) const {
  const Message message{group, true};
  send(line_, &message, sizeof message, MSG_NOSIGNAL);
}

void Cleaner::forget(pid_t group) const {
  const Message message{group, false};
  send(line_, &message, sizeof message, MSG_NOSIGNAL);
}

}  // namespace vcrit::validation
