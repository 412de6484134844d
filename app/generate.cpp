// vcrit generate: the evaluator of one scene, in C++ or another language.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "emit/generate.hpp"
#include "options.hpp"
#include "record/fields.hpp"

namespace vcrit::app {

namespace {

struct GenerateArguments {
  SceneOptions scene;
  std::string directory, name = "critical";
  symbolic::GenerateOptions generated;
  bool json = false;
};

struct Written {
  std::string language;
  std::vector<std::filesystem::path> main, files;  // as the user named the folder: DIR/NAME.hpp
  std::vector<std::string> warnings;

  friend void fields(record::Fields& f, const Written& it) {
    f("language", it.language)("main", it.main)("files", it.files).some("warnings", it.warnings);
  }
};

void generate(const GenerateArguments& options) {
  const Problem problem = options.scene.read();
  const std::vector<symbolic::CodeFile> files =
      symbolic::code_files(symbolic::derive(problem), options.name, options.generated);
  Written written{options.generated.language,
                  {},
                  symbolic::write_code(files, options.directory, problem),
                  problem->source->warnings};
  for (std::size_t i = 0; i < files.size(); ++i)
    if (files[i].is_main) written.main.push_back(written.files[i]);
  if (options.json) return print(record::json_of(written));
  for (const std::filesystem::path& file : written.main) fmt::print("{}\n", file.string());
}

// Names that people use, before the full ones are checked.
std::string full_name(std::string& language) {
  static const std::map<std::string, std::string> names{
      {"c", "c99"}, {"cpp", "c++"}, {"js", "javascript"}, {"py", "python"}};
  if (const auto found = names.find(language); found != names.end()) language = found->second;
  return {};
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
  command
      ->add_option("--language", options->generated.language,
                   "language of the evaluator; c, cpp, js, py stand for theirs")
      ->check(CLI::IsMember(symbolic::language_names()))
      ->transform(CLI::Validator(full_name, ""))
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
