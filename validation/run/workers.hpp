// Jobs in processes of their own, side by side: what they use (computer algebra with one global
// state) does not work in threads, and one that crashes takes no other with it.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "run/progress.hpp"

namespace vcrit::validation {

/// An InputError in a job, or that the system refused it something; names the job.
class JobRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How far everything is.
struct Standing {
  std::size_t done = 0, jobs = 0;
  std::vector<std::pair<std::string, std::string>> running;  ///< name of the job, its last step
};
using Watch = std::function<void(const Standing&)>;

/// The answer of a job that has none, and why.
using InPlace = std::function<std::string(std::size_t, const std::string& why)>;

/// work(i, step) for each i below names.size(), at most `at_once` at a time, each in a copy of this
/// process as it is now; the answers in order. `watch` is told of each step. What the input or the
/// system refused a job is thrown as JobRefused, and the other jobs are then ended. After any other
/// exception or a crash `in_place` answers for the job; without it a ModelError is thrown again as
/// one, the rest as std::runtime_error that names the job. Must not be called while other threads
/// run.
std::vector<std::string> in_processes(
    const std::vector<std::string>& names, unsigned at_once,
    const std::function<std::string(std::size_t, const Progress&)>& work, const Watch& watch,
    const InPlace& in_place = nullptr);

}  // namespace vcrit::validation
