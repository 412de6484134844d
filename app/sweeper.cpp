// `vcrit-sweep`, which `vcrit sweep` becomes for arrays, and which all processes of mpirun become.
#include <fmt/core.h>

#include <exception>
#include <memory>

#include "base/errors.hpp"
#include "maps/arrays.hpp"
#include "maps/mpi_ranks.hpp"
#include "program.hpp"
#include "streams.hpp"
#include "sweep_options.hpp"

namespace vcrit::app {

namespace {

// A rank that cannot go on tells why and ends them all.
void sweep_together(SweepOptions options) {
  options.stream.open_array = maps::array_opener();
  const std::unique_ptr<maps::Ranks> ranks = maps::all_ranks();
  if (ranks->size() == 1) return run_sweep(options, *ranks);
  try {
    run_sweep(options, *ranks);
  } catch (const maps::Ranks::Silent&) {
    return;
  } catch (const std::exception& error) {
    tell_line(fmt::format("vcrit: {}", with_options(error.what())));
    ranks->abort(dynamic_cast<const ModelError*>(&error) != nullptr ? 3 : 2);
  }
}

}  // namespace

}  // namespace vcrit::app

int main(int argc, char** argv) {
  using namespace vcrit::app;
  return run_program(argc, argv,
                     [](CLI::App& program, int&) { add_sweep(program, sweep_together); });
}
