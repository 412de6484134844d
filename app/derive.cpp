// vcrit derive: Eq. 24 derived for a scene, as text, LaTeX, Markdown or JSON.
#include <fmt/format.h>

#include <map>
#include <memory>

#include "commands.hpp"
#include "document/print.hpp"
#include "options.hpp"

namespace vcrit::app {

void add_derive(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    symbolic::Format format = symbolic::Format::text;
    bool limits = false;
    bool sensitivities = false;
  };
  using symbolic::Format;
  static const std::map<std::string, Format> formats{{"text", Format::text},
                                                     {"latex", Format::latex},
                                                     {"markdown", Format::markdown},
                                                     {"json", Format::json}};
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("derive", "Derive the formula of v* for a scene");
  options->scene.add_to(*command);
  command->add_option("--format", options->format, "text, latex, markdown or json")
      ->transform(CLI::Transformer(formats))
      ->check(CLI::IsMember({0, 1, 2, 3}))
      ->default_str("text");
  command->add_flag_callback(
      "--json", [options] { options->format = Format::json; }, "the same as --format json");
  command->add_flag(
      "--limits", options->limits,
      "derive the limits that apply to the scene, low and high frequency, and resonances");
  command->add_flag("--sensitivities", options->sensitivities,
                    "derive dv*/dp for every parameter p");
  command->callback([options] {
    fmt::print("{}", symbolic::print(options->scene.read(), options->format, options->limits,
                                     options->sensitivities));
  });
}

}  // namespace vcrit::app
