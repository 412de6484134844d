// vcrit fit: a Prony series from measured storage and loss stiffness, as a scene and a page.
#include "fit/fit.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/constants.hpp"
#include "base/files.hpp"
#include "base/output_places.hpp"
#include "base/rounded.hpp"
#include "base/units.hpp"
#include "commands.hpp"
#include "figures/gnuplot.hpp"
#include "fit/bounds.hpp"
#include "fit/scene_text.hpp"
#include "fit/words.hpp"
#include "options.hpp"
#include "program.hpp"
#include "record/fields.hpp"
#include "report/figure_files.hpp"
#include "report/fit_figures.hpp"
#include "report/fit_page.hpp"
#include "streams.hpp"

namespace vcrit::app {

namespace {

using fit::Fit;
using fit::KnownStiffness;
using fit::Uncertain;
using validation::report::FitContents;

struct FitOptions {
  std::string data, out, figures, punch_radius;
  fit::Options fit;
  fit::Rest rest;
  int digits = few_digits;
  bool json = false;
};

// The error itself is known to two digits at most.
std::string uncertain_words(const Uncertain& a, const char* unit, int digits) {
  return fmt::format("{:<12} ± {}", rounded(a.value, unit, digits), rounded(a.error, unit, 2));
}

void print_intervals(const std::vector<KnownStiffness>& known, int digits) {
  double largest = 0;
  for (const KnownStiffness& at : known) largest = std::max(largest, at.storage);
  const UnitScale scale = scale_for(largest, "N/m");
  const auto number = [&](double value) { return rounded(value * scale.factor, "", digits); };
  const auto interval = [&](const auto& of) {
    return fmt::format("{} to {}", number(of.low), number(of.high));
  };
  fmt::print("95 % intervals, for any number of branches, in {}:\n", scale.unit);
  fmt::print("  {:<10} {:<8} {:<20} {}\n", "frequency", "K'", "", "K''");
  for (const KnownStiffness& at : known)
    fmt::print("  {:<10} {:<8} {:<20} {:<8} {}\n", rounded(at.omega / two_pi, "Hz", digits),
               number(at.storage), interval(at.storage_interval), number(at.loss),
               interval(at.loss_interval));
}

// Without one of these the scene lacks a number.
bool is_complete(const fit::Rest& rest) {
  return !rest.frequency.empty() && !rest.amplitude.empty() && !rest.indentation.empty() &&
         !rest.coefficient.empty() && !rest.poisson.empty();
}

void print_fit_text(const FitContents& result, bool complete, int digits) {
  const Fit& fit = result.fit;
  for (const std::string& words : result.words) fmt::print("{}\n", words);
  if (fit.equilibrium) fmt::print("  k0   {}\n", uncertain_words(*fit.equilibrium, "N/m", digits));
  if (fit.damper) fmt::print("  c0   {}\n", uncertain_words(*fit.damper, "N s/m", digits));
  for (const auto& [k, tau] : fit.branches)
    fmt::print("  k    {:<26} tau  {}\n", uncertain_words(k, "N/m", digits),
               uncertain_words(tau, "s", digits));
  print_intervals(result.known, digits);
  fmt::print("Wrote {} and, with data and series, {}.\n", result.scene, result.page);
  if (!complete) fmt::print("It lacks numbers, which vcrit check {} names.\n", result.scene);
}

std::vector<NewFile> figure_files(const StiffnessTable& data, const Fit& fit,
                                  const std::string& directory) {
  std::vector<validation::report::FigureFile> files;
  for (const auto& figure : validation::report::fit_figures(data, fit))
    files.push_back({"", figure.name, validation::figures::gnuplot(figure)});
  return validation::report::draw_figures(files, directory, [](const auto&) {});
}

// Frequencies spread over the data, and the frequency of the oscillation if it is known and lies
// within the data.
std::vector<double> frequencies_of_interest(const StiffnessTable& data,
                                            const std::string& frequency) {
  std::vector<double> omegas = fit::frequencies_across(data);
  if (frequency.empty()) return omegas;
  const double omega = two_pi * parse_quantity(frequency, Dimension::frequency, {"--frequency"});
  const auto place = std::lower_bound(omegas.begin(), omegas.end(), omega);
  if (place != omegas.end() && place != omegas.begin() && *place != omega)
    omegas.insert(place, omega);
  return omegas;
}

std::vector<std::string> spelled_words(const StiffnessTable& data, const Fit& fit) {
  std::vector<std::string> all = in_words(data, fit);
  for (std::string& words : all) words = with_options(words);
  return all;
}

/// No tester has a larger flat punch: such a number was meant in millimetres.
constexpr double widest_punch = 0.05;  // m

void warn_of_wide_punch(const std::string& radius) {
  const TypedNumber typed = parse_typed(radius, Dimension::length, {"--punch-radius"});
  if (typed.is_bare && typed.value >= widest_punch)
    warn(
        fmt::format("--punch-radius {0}: a bare number is in metres; if mm are meant, write "
                    "\"{0} mm\"",
                    radius));
}

// All that may be wrong is found before the first file is written.
void run_fit(const FitOptions& options) {
  const std::filesystem::path out = options.out;
  if (out.extension() != ".toml")
    throw InputError({"--out"}, fmt::format("\"{}\"", options.out), "a file ending in .toml");
  for (const char* ending : {".toml", ".html"})
    refuse_input_as_output(std::filesystem::path(out).replace_extension(ending), {options.data});
  if (!options.figures.empty()) validation::report::require_gnuplot("figures");
  const StiffnessTable data =
      read_stiffness_table(options.data, punch_of(options.punch_radius, options.rest.poisson));
  if (!options.punch_radius.empty()) warn_of_wide_punch(options.punch_radius);
  const Fit fit = fit::fitted(data, options.fit);
  const FitContents contents{
      data,
      fit,
      known_stiffness(data, fit, frequencies_of_interest(data, options.rest.frequency)),
      spelled_words(data, fit),
      options.out,
      std::filesystem::path(out).replace_extension(".html").string(),
      scene_text(fit, data, options.rest)};
  std::vector<NewFile> files{{out, contents.scene_text}, {contents.page, fit_page(contents)}};
  if (!options.figures.empty())
    for (NewFile& file : figure_files(data, fit, options.figures)) files.push_back(std::move(file));
  write_files(files);
  if (options.json)
    print(record::json_of(contents));
  else
    print_fit_text(contents, is_complete(options.rest), options.digits);
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
  add_digits(*command, options->digits);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run_fit(*options); });
}

}  // namespace vcrit::app
