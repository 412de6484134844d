// vcrit derive: Eq. 24 derived for a scene, as text, LaTeX, Markdown or JSON; and the page about
// all named rheologies.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

#include "analysis/equality.hpp"
#include "commands.hpp"
#include "document/print.hpp"
#include "options.hpp"
#include "report/catalogue_page.hpp"

namespace vcrit::app {

namespace {

/// The exit status: 0 for equal, 1 for different.
int print_comparison(const Scene& scene, const Scene& other, symbolic::Format format) {
  const symbolic::Comparison comparison = symbolic::compare(scene, other);
  fmt::print("{}", format == symbolic::Format::json ? symbolic::json_of(comparison)
                                                    : symbolic::text_of(comparison));
  return comparison.equal ? 0 : 1;
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

void add_derive(CLI::App& program, int& status) {
  struct Options {
    SceneOptions scene;
    symbolic::DocumentOptions document;
    std::string equal;
    bool catalogue = false;
  };
  using symbolic::Format;
  static const std::map<std::string, Format> formats{{"text", Format::text},
                                                     {"latex", Format::latex},
                                                     {"markdown", Format::markdown},
                                                     {"json", Format::json}};
  using symbolic::ResultForm;
  static const std::map<std::string, ResultForm> forms{
      {"by-size", ResultForm::by_size},
      {"nested", ResultForm::nested},
      {"rational", ResultForm::rational},
      {"dimensionless", ResultForm::dimensionless}};
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("derive", "Derive the formula of v* for a scene");
  options->scene.add_to(*command);
  command->add_option("--format", options->document.format, "text, latex, markdown or json")
      ->transform(CLI::Transformer(formats))
      ->check(CLI::IsMember({0, 1, 2, 3}))
      ->default_str("text");
  command->add_flag_callback(
      "--json", [options] { options->document.format = Format::json; },
      "the same as --format json");
  command->add_flag(
      "--limits", options->document.limits,
      "derive the limits that apply to the scene, low and high frequency, and resonances");
  command->add_flag("--sensitivities", options->document.sensitivities,
                    "derive dv*/dp for every parameter p");
  command
      ->add_option("--form", options->document.form,
                   "of the result: by-size, nested, rational in omega^2, or dimensionless")
      ->transform(CLI::Transformer(forms))
      ->check(CLI::IsMember({0, 1, 2, 3}))
      ->default_str("by-size");
  command
      ->add_option("--budget", options->document.budget,
                   "terms up to which the rational form is multiplied out")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--equal", options->equal,
                      "instead, prove or refute that this scene file has the same v*");
  add_catalogue(*command, options->catalogue);
  command->callback([options, &status] {
    if (options->catalogue) return fmt::print("{}", validation::report::catalogue_page());
    if (options->scene.file.empty()) throw CLI::RequiredError("SCENE");
    if (!options->equal.empty()) {
      status = print_comparison(options->scene.read(), read_scene(options->equal),
                                options->document.format);
      return;
    }
    fmt::print("{}", symbolic::print(options->scene.read(), options->document));
  });
}

}  // namespace vcrit::app
