// vcrit plot: friction over speed, v* over frequency, or one period of the motion, as a picture on
// the terminal or in a file.
#include <fmt/core.h>
#include <unistd.h>
#include <CLI/App.hpp>

#include <filesystem>
#include <memory>
#include <optional>

#include "answers/realised_friction.hpp"
#include "base/files.hpp"
#include "base/output_places.hpp"
#include "base/units.hpp"
#include "choice.hpp"
#include "commands.hpp"
#include "figures/gnuplot.hpp"
#include "figures/screen.hpp"
#include "figures/svg.hpp"
#include "options.hpp"
#include "problem/input_files.hpp"
#include "record/fields.hpp"
#include "report/figure_files.hpp"
#include "report/plots.hpp"
#include "report/records.hpp"
#include "speed_options.hpp"
#include "streams.hpp"

namespace vcrit::app {

namespace {

using validation::figures::Figure;

enum class Shown { friction, frequency, cycle };

struct PlotOptions {
  SceneOptions scene;
  Shown shown = Shown::friction;
  SpeedOptions speed;
  std::string to, out;
  bool json = false;
};

struct Plotted {
  std::string file;  // empty: none
  const std::vector<Figure>& figures;

  friend void fields(record::Fields& f, const Plotted& it) {
    f("file", it.file.empty() ? std::nullopt : std::optional(it.file))("figures", it.figures);
  }
};

std::optional<double> largest_speed(const PlotOptions& options) {
  if (options.to.empty()) return std::nullopt;
  return parse_quantity(options.to, Dimension::velocity, {"--to"});
}

std::vector<Figure> figures_of(const PlotOptions& options, const Problem& problem) {
  switch (options.shown) {
    case Shown::friction:
      return validation::report::friction_plot(problem, largest_speed(options));
    case Shown::frequency:
      return validation::report::frequency_plot(problem);
    case Shown::cycle:
      return validation::report::cycle_plot(problem, options.speed.of(problem).velocity);
  }
  throw Bug("a picture without a way to make it");
}

// An option that the picture has no use for is a mistake of somebody who expected another picture.
void refuse_unused(const PlotOptions& options) {
  if (!options.to.empty() && options.shown != Shown::friction)
    throw InputError({"--to"}, fmt::format("\"{}\" with another picture", options.to),
                     "friction over speed", "leave out --over, --of and --cycle");
  if (options.shown != Shown::cycle)
    if (const std::string given = options.speed.given(); !given.empty())
      throw InputError({given}, "a picture of more than one speed", "--cycle with it",
                       "--to SPEED is the largest speed of a picture of friction");
}

// Wrong names are found before anything is computed.
std::filesystem::path file_of(const PlotOptions& options) {
  const std::filesystem::path out = options.out;
  if (out.extension() == ".pdf")
    validation::report::require_gnuplot("out");
  else if (!out.empty() && out.extension() != ".svg")
    throw InputError({"--out"}, fmt::format("\"{}\"", options.out),
                     "a file ending in .svg or .pdf");
  return out;
}

/// For people at a terminal: what else may be drawn.
constexpr const char* const other_pictures =
    "more: --over frequency | --cycle | --to SPEED | --out FILE.svg";

void plot(const PlotOptions& options) {
  refuse_unused(options);
  const std::filesystem::path out = file_of(options);
  const Problem problem =
      options.scene.read(options.shown == Shown::frequency ? SceneOptions::Frequency::varied
                                                           : SceneOptions::Frequency::of_the_scene);
  refuse_input_as_output(out, input_files(problem));
  if (options.shown != Shown::frequency)
    for (const std::string& warning : unstated_error(problem)) warn(warning);
  const std::vector<Figure> figures = figures_of(options, problem);
  if (!out.empty())
    write_file(out, out.extension() == ".pdf" ? validation::report::pdf_of(figures)
                                              : validation::figures::svg(figures));
  if (options.json) return print(record::json_of(Plotted{out.string(), figures}));
  if (out.empty()) {
    for (const Figure& figure : figures)
      fmt::print("{}{}", &figure == &figures.front() ? "" : "\n",
                 validation::figures::on_screen(figure));
    if (isatty(STDOUT_FILENO) == 1) fmt::print("\n{}\n", other_pictures);
    return;
  }
  fmt::print("{}\n", out.string());
}

// Another word for speed, and what is drawn over it, before the names are checked.
std::string picture_over(std::string& name) {
  if (name == "friction" || name == "velocity") name = "speed";
  return {};
}

}  // namespace

void add_plot(CLI::App& program) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* command =
      program.add_subcommand("plot", "Draw friction over speed, v* over frequency, or one period");
  options->scene.add_to(*command);
  CLI::Option* over = add_choice(
      *command, "--over,--of", options->shown,
      {{"speed", Shown::friction}, {"frequency", Shown::frequency}, {"cycle", Shown::cycle}},
      "friction over speed; v* over frequency; force and velocity over one period");
  over->transform(CLI::Validator(picture_over, ""));
  command
      ->add_flag_callback(
          "--cycle", [options] { options->shown = Shown::cycle; }, "the same as --over cycle")
      ->excludes(over);
  options->speed.add_to(*command, 0.5);
  command->add_option("--to", options->to,
                      "largest speed of the picture of friction: \"10 mm/s\"; else 1.3 times v*");
  command->add_option(
      "--out", options->out,
      "FILE.svg, or FILE.pdf by gnuplot; without it the terminal shows the picture");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { plot(*options); });
}

}  // namespace vcrit::app
