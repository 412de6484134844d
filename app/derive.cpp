// vcrit derive: Eq. 24 derived for a scene, as text, LaTeX, Markdown, HTML, JSON or for other
// systems; and the pages about its networks and about all named rheologies.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include <memory>
#include <string>
#include <vector>

#include "analysis/equality.hpp"
#include "choice.hpp"
#include "commands.hpp"
#include "document/print.hpp"
#include "options.hpp"

namespace vcrit::app {

namespace {

using symbolic::Format;
using symbolic::ResultForm;

/// A format, with the computer algebra system that reads it, if one does.
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

const Choices<ResultForm> forms{
    {"shortest", ResultForm::shortest},           {"nested", ResultForm::nested},
    {"storage-loss", ResultForm::storage_loss},   {"rational", ResultForm::rational},
    {"dimensionless", ResultForm::dimensionless}, {"expanded", ResultForm::expanded}};

/// The exit status: 0 for equal, 1 for different.
int print_comparison(const Problem& problem, const Problem& other, const FormatChoice& chosen) {
  if (chosen.format == Format::system)
    throw InputError(argument("equal"), "the format " + chosen.system, "text or json");
  const symbolic::Equality comparison = symbolic::compare(problem, other);
  fmt::print("{}", chosen.format == Format::json ? symbolic::json_of(comparison)
                                                 : symbolic::text_of(comparison));
  return comparison.equal ? 0 : 1;
}

/// A flag that takes the place of the derivation: no other option goes with it but `these`.
void add_page(CLI::App& command, const char* name, bool& wanted, const char* words,
              const std::vector<CLI::Option*>& these) {
  CLI::Option* page = command.add_flag(name, wanted, words);
  for (CLI::Option* option : command.get_options())
    if (option != page && std::find(these.begin(), these.end(), option) == these.end())
      page->excludes(option);
}

void add_pages(CLI::App& command, bool& catalogue, bool& material) {
  CLI::Option* scene = command.get_option("SCENE");
  CLI::Option* help = command.get_help_ptr();
  scene->required(false);
  add_page(
      command, "--material", material,
      "instead, a page (HTML) about the networks of the scene: storage and loss, spectra, creep "
      "and relaxation",
      {scene, help});
  add_page(command, "--catalogue", catalogue,
           "instead of a scene, a page (HTML) about all named rheologies", {help});
}

}  // namespace

void add_derive(CLI::App& program, int& status, const DerivePages* pages) {
  struct Options {
    SceneOptions scene;
    symbolic::DocumentOptions document;
    FormatChoice format;
    std::string equal;
    bool catalogue = false, material = false;
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
                         "of the result; shortest: real, in named steps; nested: in complex "
                         "stiffnesses; storage-loss: in K' and K''; rational: in omega^2");
  command
      ->add_option("--budget", options->document.budget,
                   "terms up to which v* is expanded or written as a rational function")
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
  if (pages != nullptr) add_pages(*command, options->catalogue, options->material);
  command->callback([options, &status, pages] {
    if (options->catalogue) return fmt::print("{}", pages->catalogue());
    if (options->scene.file.empty()) throw CLI::RequiredError("SCENE");
    if (options->material) return fmt::print("{}", pages->material(options->scene.read()));
    if (!options->equal.empty()) {
      status =
          print_comparison(options->scene.read(), read_problem(options->equal), options->format);
      return;
    }
    options->document.format = options->format.format;
    options->document.system = options->format.system;
    fmt::print("{}", symbolic::print(options->scene.read(), options->document));
  });
}

}  // namespace vcrit::app
