// vcrit derive: Eq. 24 derived for a scene, as text, LaTeX, Markdown, JSON or for other
// systems; and the page about all named rheologies.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>

#include "analysis/equality.hpp"
#include "base/errors.hpp"
#include "commands.hpp"
#include "document/print.hpp"
#include "options.hpp"

namespace vcrit::app {

namespace {

using symbolic::Format;
using symbolic::ResultForm;

/// A format, and the system where it is one.
struct FormatChoice {
  Format format = Format::text;
  std::string system = {};
};

Choices<FormatChoice> formats() {
  Choices<FormatChoice> all{{"text", {Format::text}},
                            {"latex", {Format::latex}},
                            {"markdown", {Format::markdown}},
                            {"html", {Format::html}},
                            {"json", {Format::json}}};
  for (const std::string& name : symbolic::system_names())
    all.push_back({name, {Format::system, name}});
  return all;
}

const Choices<ResultForm> forms{{"shortest", ResultForm::shortest},
                                {"by-size", ResultForm::by_size},
                                {"nested", ResultForm::nested},
                                {"rational", ResultForm::rational},
                                {"dimensionless", ResultForm::dimensionless}};

/// The exit status: 0 for equal, 1 for different.
int print_comparison(const Problem& problem, const Problem& other, const FormatChoice& chosen) {
  if (chosen.format == Format::system)
    throw InputError(argument("equal"), "the format " + chosen.system, "text or json");
  const symbolic::Comparison comparison = symbolic::compare(problem, other);
  fmt::print("{}", chosen.format == Format::json ? symbolic::json_of(comparison)
                                                 : symbolic::text_of(comparison));
  return comparison.equal ? 0 : 1;
}

/// HTML is always a page of its own; what other formats write is a part of nothing.
void check_standalone(const symbolic::DocumentOptions& options) {
  if (!options.standalone || options.format == Format::latex || options.format == Format::html)
    return;
  const auto named = std::find_if(formats.begin(), formats.end(), [&](const auto& each) {
    return each.second == options.format;
  });
  throw InputError(argument("standalone"), fmt::format("--format {}", named->first),
                   "--format latex, for an article, or html, which is a page with or without it");
}

/// Takes the place of a scene: no other option goes with it.
void add_catalogue(CLI::App& command, bool& wanted) {
  command.get_option("SCENE")->required(false);
  CLI::Option* catalogue = command.add_flag(
      "--catalogue", wanted, "instead of a scene, a page (HTML) about all named rheologies");
  for (CLI::Option* option : command.get_options())
    if (option != catalogue && option != command.get_help_ptr()) catalogue->excludes(option);
}

}  // namespace

void add_derive(CLI::App& program, int& status, std::string (*catalogue)()) {
  struct Options {
    SceneOptions scene;
    symbolic::DocumentOptions document;
    FormatChoice format;
    std::string equal;
    bool catalogue = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("derive", "Derive the formula of v* for a scene");
  options->scene.add_to(*command);
  add_choice<FormatChoice>(*command, "--format", options->format, formats(),
                           "of the output; from sympy on the result alone, for that system");
  command->add_flag("--standalone", options->document.standalone,
                    "with --format latex: an article that pdflatex compiles, not a part of one");
  command->add_flag_callback(
      "--json", [options] { options->format = {Format::json}; }, "the same as --format json");
  command->add_flag(
      "--limits", options->document.limits,
      "derive the limits that apply to the scene, low and high frequency, and resonances");
  command->add_flag("--sensitivities", options->document.sensitivities,
                    "derive dv*/dp for every parameter p");
  add_choice<ResultForm>(*command, "--form", options->document.form, forms,
                         "of the result; shortest: real, in named steps; rational: in omega^2");
  command
      ->add_option("--budget", options->document.budget,
                   "terms up to which the rational form is multiplied out")
      ->check([](const std::string& text) {
        double terms = 0;
        const bool fits = CLI::detail::lexical_cast(text, terms) && terms > 0;
        return fits ? "" : "found " + text + "; expected a number of terms above 0";
      })
      ->capture_default_str();
  command
      ->add_option("--equal", options->equal,
                   "instead, prove or refute that this scene has the same v*")
      ->type_name("SCENE");
  if (catalogue) add_catalogue(*command, options->catalogue);
  command->callback([options, &status, catalogue] {
    if (options->catalogue) return fmt::print("{}", catalogue());
    if (options->scene.file.empty()) throw CLI::RequiredError("SCENE");
    if (!options->equal.empty()) {
      status =
          print_comparison(options->scene.read(), read_problem(options->equal), options->format);
      return;
    }
    options->document.format = options->format.format;
    options->document.system = options->format.system;
    check_standalone(options->document);
    fmt::print("{}", symbolic::print(options->scene.read(), options->document));
  });
}

}  // namespace vcrit::app
