// vcrit generate: the C++ evaluator of one scene.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "emit/generate.hpp"
#include "options.hpp"

namespace vcrit::app {

void add_generate(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    std::string directory, name = "critical", language = "c++";
    symbolic::GenerateOptions generated;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("generate", "Generate a C++ evaluator for exactly this scene");
  options->scene.add_to(*command);
  command->add_option("--out", options->directory, "folder to write to")
      ->required()
      ->type_name("DIR");
  command->add_option("--name", options->name, "namespace and file name")->capture_default_str();
  command->add_option("--language", options->language)
      ->check(CLI::IsMember({"c++"}))
      ->capture_default_str();
  command
      ->add_option("--fix", options->generated.fixed,
                   "fold these parameters in with their numbers in the scene: k0,c1; an array by "
                   "its name or k[3]; all")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->allow_extra_args(false);
  command->add_flag("--quantities", options->generated.quantities,
                    "also DIR/NAME_quantities.hpp: stiffnesses, amplitudes and phases, the "
                    "admissible amplitude, dimensionless groups");
  command->callback([options] {
    symbolic::generate(options->scene.read(), options->directory, options->name,
                       options->generated);
    fmt::print("{}/{}.hpp\n", options->directory, options->name);
    if (options->generated.quantities)
      fmt::print("{}/{}_quantities.hpp\n", options->directory, options->name);
  });
}

}  // namespace vcrit::app
