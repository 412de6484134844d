#include "sweep_options.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <memory>
#include <utility>

#include "base/joined.hpp"
#include "sweep/sweep.hpp"

namespace vcrit::app {

void add_sweep(CLI::App& program, std::function<void(const SweepOptions&)> run) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand("sweep", "Quantities over a grid of parameters");
  options->scene.add_to(*command);
  command
      ->add_option("--over", options->over,
                   "an axis, NAME=lin|log:FROM:TO:N or NAME=list:FILE, NAME as for --set, velocity "
                   "or velocity_ratio")
      ->required();
  command
      ->add_option("--quantity", options->quantities, "what to compute, one or several")
      // Words for help and completion; the sweep itself checks the names.
      ->type_name(fmt::format("NAME:{{{}}}", joined(swept_quantity_names(), ",")))
      ->required();
  CLI::Option* velocity = command->add_option("--velocity", options->velocity,
                                              "one velocity of the drive for all rows");
  command
      ->add_option("--velocity-ratio", options->velocity_ratio,
                   "drive speed as a multiple of v*: 0.5 or 50%")
      ->type_name("RATIO")
      ->excludes(velocity);
  command->add_option("--out", options->out,
                      "FILE.csv, or FILE.h5 or .nc (HDF5 by the conventions of netCDF-4), in SI "
                      "units; - for CSV on stdout, without it a table");
  command->add_flag(
      "--units", options->units,
      "units in the header of CSV, as netCDF and the table have them: frequency [Hz]");
  command->add_flag("--resume", options->stream.resume, "continue the unfinished FILE.part");
  command
      ->add_option("--threads", options->stream.threads,
                   "number of threads (default: one per core)")
      ->check(CLI::Range(1, 4096));
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, run = std::move(run)] { run(*options); });
}

}  // namespace vcrit::app
