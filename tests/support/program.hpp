// Other programs run by tests: without a shell, in a folder of the test's own.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

extern char** environ;

namespace vcrit::test {

/// A folder that only this process uses, removed at the end.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "vcrit-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

struct Outcome {
  int status = -1;     ///< exit status, -1 if the program could not be started or was killed
  std::string output;  ///< stdout and stderr together
};

/// Runs a program (looked up in PATH) with its output in a file of `folder`.
inline Outcome run(const std::vector<std::string>& command, const std::filesystem::path& folder,
                   const std::string& input_file = "/dev/null") {
  const std::string log = (folder / "output.log").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, input_file.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  Outcome outcome;
  if (failed != 0) return outcome;
  int status = 0;
  waitpid(child, &status, 0);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.output = contents(log);
  return outcome;
}

inline std::string missing_tool(const std::string& name) {
  return name + " is missing or does not run; ./dev test installs it";
}

/// Whether a command that tells of a program succeeds; each is run once.
inline bool is_present(const std::vector<std::string>& command,
                       const std::filesystem::path& folder) {
  static std::map<std::vector<std::string>, bool> known;
  const auto [place, is_new] = known.try_emplace(command);
  if (is_new) place->second = run(command, folder).status == 0;
  return place->second;
}

/// Throws where a program does not run that all tests may count on.
inline void require_tool(const std::string& name, const std::filesystem::path& folder) {
  if (!is_present({name, "--version"}, folder)) throw std::runtime_error(missing_tool(name));
}

}  // namespace vcrit::test
