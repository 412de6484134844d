// vcrit sweep: tables here, arrays by a program that this one becomes. Loading netCDF, MPI and the
// forty libraries behind them takes longer than most commands take to start and answer.
#include <fmt/core.h>
#include <unistd.h>
#include <CLI/App.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "commands.hpp"
#include "maps/map_file.hpp"
#include "maps/ranks.hpp"
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
  add_sweep(program, [argv](const SweepOptions& options) {
    if (maps::started_ranks() > 1 || maps::is_array(options.out)) become_sweeper(argv);
    maps::Ranks alone;
    run_sweep(options, alone);
  });
}

}  // namespace vcrit::app
