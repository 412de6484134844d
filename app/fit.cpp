// vcrit fit: a Prony series from measured storage and loss stiffness, as a scene and a page.
#include "fit/fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/constants.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "commands.hpp"
#include "figures/gnuplot.hpp"
#include "fit/bounds.hpp"
#include "fit/scene_text.hpp"
#include "fit/words.hpp"
#include "options.hpp"
#include "problem/problem.hpp"
#include "program.hpp"
#include "record/fields.hpp"
#include "report/figure_files.hpp"
#include "report/fit_figures.hpp"
#include "report/fit_page.hpp"

namespace vcrit::app {

namespace {

using fit::Data;
using fit::Fit;
using fit::KnownStiffness;
using fit::Uncertain;
using validation::report::FitContents;

struct FitOptions {
  std::string data, out, figures, punch_radius;
  fit::Options fit;
  fit::Rest rest;
  bool json = false;
};

void print_line(const char* name, const Uncertain& a, const char* unit) {
  fmt::print("{:<4} {:<12.6g} +- {:<8.2g} {}", name, a.value, a.error, unit);
}

void print_intervals(const std::vector<KnownStiffness>& known) {
  fmt::print("95 % intervals, for any number of branches:\n{:>10}  {:>10}  {:<24}  {:>10}  {}\n",
             "Hz", "K', N/m", "", "K'', N/m", "");
  for (const KnownStiffness& at : known)
    fmt::print("{:>10.4g}  {:>10.4g}  {:<24}  {:>10.4g}  {}\n", at.omega / two_pi, at.storage,
               fmt::format("{:.4g} to {:.4g}", at.storage_interval.low, at.storage_interval.high),
               at.loss,
               fmt::format("{:.4g} to {:.4g}", at.loss_interval.low, at.loss_interval.high));
}

void print_fit_text(const FitContents& result) {
  const Fit& fit = result.fit;
  for (const std::string& words : result.words) fmt::print("{}\n", words);
  if (fit.equilibrium) print_line("k0", *fit.equilibrium, "N/m\n");
  if (fit.damper) print_line("c0", *fit.damper, "N s/m\n");
  for (const auto& [k, tau] : fit.branches) {
    print_line("k", k, "N/m   ");
    print_line("tau", tau, "s\n");
  }
  print_intervals(result.known);
  fmt::print("{}\n{}\n", result.scene, result.page);
}

std::vector<NewFile> figure_files(const Data& data, const Fit& fit, const std::string& directory) {
  std::vector<validation::report::FigureFile> files;
  for (const auto& figure : validation::report::fit_figures(data, fit))
    files.push_back({"", figure.name, validation::figures::gnuplot(figure)});
  return validation::report::draw_figures(files, directory, [](const auto&) {});
}

// Across the data; and where the contact will oscillate, if that is known and within them.
std::vector<double> frequencies_of_interest(const Data& data, const std::string& frequency) {
  std::vector<double> omegas = frequencies_across(data);
  if (frequency.empty()) return omegas;
  const double omega = two_pi * parse_quantity(frequency, Dimension::frequency, {"--frequency"});
  const auto place = std::lower_bound(omegas.begin(), omegas.end(), omega);
  if (place != omegas.end() && place != omegas.begin() && *place != omega)
    omegas.insert(place, omega);
  return omegas;
}

std::vector<std::string> spelled_words(const Data& data, const Fit& fit) {
  std::vector<std::string> all = in_words(data, fit);
  for (std::string& words : all) words = with_options(words);
  return all;
}

// All that may be wrong is found before the first file is written.
void run_fit(const FitOptions& options) {
  const std::filesystem::path out = options.out;
  if (out.extension() != ".toml")
    throw InputError({"--out"}, fmt::format("\"{}\"", options.out), "a file ending in .toml");
  if (!options.figures.empty()) validation::report::require_gnuplot("figures");
  const Data data =
      fit::read_data(options.data, fit::punch_of(options.punch_radius, options.rest.poisson));
  const Fit fit = fit::fitted(data, options.fit);
  const FitContents contents{
      data,
      fit,
      known_stiffness(data, fit, frequencies_of_interest(data, options.rest.frequency)),
      spelled_words(data, fit),
      options.out,
      std::filesystem::path(out).replace_extension(".html").string(),
      scene_text(fit, data, options.rest)};
  parse_problem(contents.scene_text, options.out);
  std::vector<NewFile> files{{out, contents.scene_text}, {contents.page, fit_page(contents)}};
  if (!options.figures.empty())
    for (NewFile& file : figure_files(data, fit, options.figures)) files.push_back(std::move(file));
  write_files(files);
  if (options.json)
    print(record::json_of(contents));
  else
    print_fit_text(contents);
}

}  // namespace

void add_fit(CLI::App& program) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = program.add_subcommand(
      "fit", "Fit a Prony series to measured storage and loss stiffness; write a scene");
  command
      ->add_option("DATA", options->data,
                   "table (CSV) with the columns frequency or angular_frequency, storage, loss or "
                   "tan_delta")
      ->required();
  command
      ->add_option("--out", options->out, "the scene, FILE.toml; a page FILE.html stands beside it")
      ->required();
  command->add_flag("--damper", options->fit.damper,
                    "try a damper from the start, not only where branches fail");
  command
      ->add_option("--max-branches", options->fit.most_branches,
                   "maximum number of Maxwell branches")
      ->capture_default_str();
  command->add_option("--title", options->rest.title, "title of the scene");
  command->add_option("--poisson", options->rest.poisson, "Poisson's ratio for the scene");
  command->add_option("--punch-radius", options->punch_radius,
                      "radius of a flat punch, for tables of moduli (MPa): \"0.5 mm\"");
  command->add_option("--frequency", options->rest.frequency,
                      "frequency of the oscillation: \"20 kHz\"");
  command->add_option("--amplitude", options->rest.amplitude,
                      "amplitude of the oscillation: \"0.1 um\"");
  command->add_option("--indentation", options->rest.indentation, "mean indentation: \"0.5 um\"");
  command->add_option("--coefficient", options->rest.coefficient, "coefficient of friction");
  command->add_option("--figures", options->figures, "folder for the figures as SVG and PDF")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run_fit(*options); });
}

}  // namespace vcrit::app
