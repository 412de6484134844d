// What computed the report: machine, operating system, and the versions of all parts.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace vcrit::validation {

struct Machine {
  std::string processor;
  unsigned cores = 0;   ///< as the operating system counts them
  std::string system;   ///< "Debian GNU/Linux 12 (bookworm), Linux 6.1.0"
  std::string program;  ///< version of vcrit
  std::string commit;   ///< of its sources, "unknown" outside a repository; + where they differ
  std::string compiler_flags;                                 ///< with which vcrit was compiled
  std::vector<std::pair<std::string, std::string>> versions;  ///< name and version of each part
};

Machine this_machine();

}  // namespace vcrit::validation
