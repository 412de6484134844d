#include "streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <system_error>

#include "base/plain_text.hpp"

namespace vcrit::app {

namespace {

InputError refused(const std::string& where, const std::string& found) {
  return {{where}, found, "a place that can be written"};
}

}  // namespace

void open_missing_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    // Opened for reading, it refuses what is printed; the lowest free number is the missing one.
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDONLY) < 0) std::abort();
}

void tell(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void tell_line(std::string_view text) { tell("{}\n", without_steering(text)); }

std::string alarming(const std::string& text, int stream) {
  const char* const unwanted = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool coloured = ::isatty(stream) == 1 && (unwanted == nullptr || *unwanted == '\0') &&
                        terminal != nullptr && std::string_view(terminal) != "dumb";
  return coloured ? "\033[31m" + text + "\033[0m" : text;
}

namespace {

std::optional<std::vector<std::string>>& kept() {
  static std::optional<std::vector<std::string>> warnings;
  return warnings;
}

}  // namespace

void warn(const std::string& warning) {
  if (kept()) return kept()->push_back(warning);
  tell_line("vcrit: warning: " + warning);
}

void keep_warnings() { kept().emplace(); }

std::vector<std::string> kept_warnings() {
  if (!kept()) return {};
  return *std::exchange(kept(), std::nullopt);
}

void finish_stdout() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw refused("stdout", std::generic_category().message(errno == 0 ? EIO : errno));
}

InputError in_words(const std::system_error& error) {
  if (std::ferror(stdout) != 0) return refused("stdout", error.code().message());
  return {{"the system"}, error.what(), "room, permission and processes to work with"};
}

}  // namespace vcrit::app
