// vcrit generate: the evaluator of one scene, in C++ or another language.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "commands.hpp"
#include "emit/generate.hpp"
#include "emit/languages/languages.hpp"
#include "options.hpp"

namespace vcrit::app {

namespace {

std::vector<std::string> all_languages() {
  std::vector<std::string> names = symbolic::language_names();
  names.insert(names.begin(), "c++");
  return names;
}

/// Writes the evaluator and returns the files that are to be included or imported.
std::vector<std::string> write(const Scene& scene, const std::string& directory,
                               const std::string& name, const symbolic::GenerateOptions& options) {
  const std::string stem = directory + "/" + name;
  const std::vector<std::string>& names = symbolic::language_names();
  const auto other = std::find(names.begin(), names.end(), options.language);
  if (other == names.end()) {
    symbolic::generate(scene, directory, name, options);
    if (!options.quantities) return {stem + ".hpp"};
    return {stem + ".hpp", stem + "_quantities.hpp"};
  }
  if (options.quantities)
    throw InputError({"--quantities"}, fmt::format("--language {}", options.language),
                     "--language c++, the only one with other quantities");
  const auto chosen = static_cast<symbolic::Language>(other - names.begin());
  symbolic::generate(scene, directory, name, chosen, options);
  return {stem + symbolic::extension(chosen)};
}

}  // namespace

void add_generate(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    std::string directory, name = "critical";
    symbolic::GenerateOptions generated;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("generate", "Generate an evaluator for exactly this scene");
  options->scene.add_to(*command);
  command->add_option("--out", options->directory, "folder to write to")
      ->required()
      ->type_name("DIR");
  command->add_option("--name", options->name, "namespace, prefix or module, and file name")
      ->capture_default_str();
  command->add_option("--language", options->generated.language, "language of the evaluator")
      ->check(CLI::IsMember(all_languages()))
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
    for (const std::string& file :
         write(options->scene.read(), options->directory, options->name, options->generated))
      fmt::print("{}\n", file);
  });
}

}  // namespace vcrit::app
