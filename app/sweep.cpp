// vcrit sweep: quantities of a scene over a grid of its parameters and the speed, as a table.
#include "sweep/sweep.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/files.hpp"
#include "base/units.hpp"
#include "commands.hpp"
#include "options.hpp"

namespace vcrit::app {

namespace {

struct Options {
  SceneOptions scene;
  std::vector<std::string> over;
  std::vector<std::string> quantities;
  std::string velocity, out;
  std::optional<double> velocity_ratio;
};

constexpr std::array quantities{SweptQuantity::critical_velocity, SweptQuantity::friction_ratio,
                                SweptQuantity::friction_ratio_error};

std::vector<std::string> names_of_quantities() {
  std::vector<std::string> names;
  for (const SweptQuantity quantity : quantities) names.emplace_back(to_text(quantity));
  return names;
}

Sweep sweep_of(const Options& options) {
  Sweep sweep{options.scene.read(), options.scene.split_settings(), {}, {}, {}, {}};
  for (const std::string& axis : options.over) sweep.axes.push_back(parse_axis(axis, sweep.scene));
  for (const std::string& name : options.quantities)
    for (const SweptQuantity quantity : quantities)
      if (name == to_text(quantity)) sweep.quantities.push_back(quantity);
  if (!options.velocity.empty())
    sweep.velocity = parse_quantity(options.velocity, Dimension::velocity, {"--velocity"});
  sweep.velocity_ratio = options.velocity_ratio;
  return sweep;
}

void run(const Options& options) {
  const std::filesystem::path file = options.out;
  if (file.extension() != ".csv")
    throw InputError({"--out"}, fmt::format("\"{}\"", options.out), "a file ending in .csv");
  const SweptTable table = swept(sweep_of(options));
  if (table.outside == table.rows) throw ModelError(table.reason);
  write_file(file, to_csv(table));
  if (table.outside > 0)
    fmt::print(stderr, "vcrit: warning: {} of {} rows are outside the model (nan); the first: {}\n",
               table.outside, table.rows, table.reason);
}

}  // namespace

void add_sweep(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("sweep", "Quantities over a grid of parameters");
  options->scene.add_to(*command);
  command
      ->add_option("--over", options->over,
                   "an axis, NAME=lin|log:FROM:TO:N, NAME as for --set, velocity or velocity_ratio")
      ->required();
  command->add_option("--quantity", options->quantities, "what to compute, one or several")
      ->required()
      ->check(CLI::IsMember(names_of_quantities()));
  CLI::Option* velocity = command->add_option("--velocity", options->velocity,
                                              "one velocity of the drive for all rows");
  command->add_option("--velocity-ratio", options->velocity_ratio, "the same in units of v*")
      ->excludes(velocity);
  command->add_option("--out", options->out, "the table, FILE.csv")->required();
  command->callback([options] { run(*options); });
}

}  // namespace vcrit::app
