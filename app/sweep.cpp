// vcrit sweep: becomes the program that sweeps. Loading netCDF, MPI and the forty libraries behind
// them takes more than half of the time in which any other command starts and answers.
#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "commands.hpp"
#include "program.hpp"
#include "sweep_options.hpp"

namespace vcrit::app {

namespace {

namespace fs = std::filesystem;

/// Beside this program where it was built, in a folder of its own where it was installed.
void become_sweeper(char** argv) {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& program : {here / "vcrit-sweep", here / VCRIT_SWEEPER_INSTALLED})
    ::execv(program.c_str(), argv);
  throw Refused(fmt::format("{} cannot be started ({}): install all of vcrit",
                            (here / VCRIT_SWEEPER_INSTALLED).lexically_normal().string(),
                            std::strerror(errno)));
}

}  // namespace

void add_sweep(CLI::App& program, char** argv) {
  add_sweep(program, [argv](const SweepOptions&) { become_sweeper(argv); });
}

}  // namespace vcrit::app
