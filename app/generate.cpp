// vcrit generate: the evaluator of one scene, in C++ or another language.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

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

struct GenerateArguments {
  SceneOptions scene;
  std::string directory, name = "critical";
  symbolic::GenerateOptions generated;
  bool json = false;
};

/// Paths as the user named the folder: DIR/NAME.hpp.
struct Written {
  std::vector<std::filesystem::path> main;  // to be included or imported
  std::vector<std::filesystem::path> all;
};

Written write_cpp(const symbolic::Derivation& derivation, const GenerateArguments& options) {
  const std::filesystem::path directory = options.directory;
  Written written{{directory / (options.name + ".hpp")}, {}};
  if (options.generated.quantities)
    written.main.push_back(directory / (options.name + "_quantities.hpp"));
  written.all = symbolic::generate(derivation, options.directory, options.name, options.generated);
  return written;
}

Written write(const Scene& scene, const GenerateArguments& options) {
  const symbolic::Derivation derivation = symbolic::derive(scene);
  const std::vector<std::string>& names = symbolic::language_names();
  const auto other = std::find(names.begin(), names.end(), options.generated.language);
  if (other == names.end()) return write_cpp(derivation, options);
  if (options.generated.quantities)
    throw InputError({"--quantities"}, fmt::format("--language {}", options.generated.language),
                     "--language c++, the only one with other quantities");
  const auto chosen = static_cast<symbolic::Language>(other - names.begin());
  const auto file =
      symbolic::generate(derivation, options.directory, options.name, chosen, options.generated);
  return {{file}, {file}};
}

std::vector<std::string> as_text(const std::vector<std::filesystem::path>& files) {
  return {files.begin(), files.end()};
}

void generate(const GenerateArguments& options) {
  const Scene scene = options.scene.read();
  const Written written = write(scene, options);
  if (options.json)
    return print(with_warnings({{"language", options.generated.language},
                                {"main", as_text(written.main)},
                                {"files", as_text(written.all)}},
                               scene.warnings));
  for (const std::filesystem::path& file : written.main) fmt::print("{}\n", file.string());
}

}  // namespace

void add_generate(CLI::App& program) {
  const auto options = std::make_shared<GenerateArguments>();
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
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { generate(*options); });
}

}  // namespace vcrit::app
