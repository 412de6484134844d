// vcrit explore: a page in which the scene's parameters can be moved.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include <filesystem>
#include <memory>

#include "base/files.hpp"
#include "base/output_places.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "problem/input_files.hpp"
#include "record/fields.hpp"
#include "report/explore_page.hpp"

namespace vcrit::app {

namespace {

struct ExploreOptions {
  SceneOptions scene;
  std::string out;
  bool json = false;
};

struct Explored {
  std::string file;
  std::size_t bytes;

  friend void fields(record::Fields& f, const Explored& it) {
    f("file", it.file)("bytes", it.bytes);
  }
};

// "my.explore.html" for my.toml, in the folder where vcrit runs.
std::filesystem::path page_file(const ExploreOptions& options) {
  if (!options.out.empty()) return options.out;
  return std::filesystem::path(options.scene.file).stem().string() + ".explore.html";
}

void explore(const ExploreOptions& options) {
  const Problem problem = options.scene.read();
  const std::filesystem::path out = page_file(options);
  refuse_input_as_output(out, input_files(problem));
  const std::string page = validation::report::explore_page(problem);
  write_file(out, page);
  if (options.json) return print(record::json_of(Explored{out.string(), page.size()}));
  fmt::print("Wrote {0} ({1:.1f} MB, works offline). Open it: xdg-open {0}\n", out.string(),
             static_cast<double>(page.size()) / 1e6);
}

}  // namespace

void add_explore(CLI::App& program) {
  const auto options = std::make_shared<ExploreOptions>();
  CLI::App* command = program.add_subcommand(
      "explore", "Write a page in which you move the parameters and see v* and friction follow");
  options->scene.add_to(*command);
  command->add_option("--out", options->out, "FILE.html; by default the scene's name");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { explore(*options); });
}

}  // namespace vcrit::app
