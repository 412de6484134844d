// vcrit generate: the evaluator of one scene, in C++ or another language.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

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

/// Writes the evaluator and returns the file that is to be included or imported.
std::string write(const Scene& scene, const std::string& directory, const std::string& name,
                  const std::string& language) {
  const std::vector<std::string>& names = symbolic::language_names();
  const auto other = std::find(names.begin(), names.end(), language);
  if (other == names.end()) {
    symbolic::generate(scene, directory, name);
    return directory + "/" + name + ".hpp";
  }
  const auto chosen = static_cast<symbolic::Language>(other - names.begin());
  symbolic::generate(scene, directory, name, chosen);
  return directory + "/" + name + symbolic::extension(chosen);
}

}  // namespace

void add_generate(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    std::string directory, name = "critical", language = "c++";
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
  command->add_option("--language", options->language, "language of the evaluator")
      ->check(CLI::IsMember(all_languages()))
      ->capture_default_str();
  command->callback([options] {
    fmt::print("{}\n",
               write(options->scene.read(), options->directory, options->name, options->language));
  });
}

}  // namespace vcrit::app
