#include "examples.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <map>
#include <string>
#include <vector>

namespace vcrit::app {

namespace {

struct Example {
  const char* words;
  const char* line;
};

const std::vector<Example> program_examples{
    {"The critical velocity of a scene, with a bound on its error", "vcrit eval scenes/zener.toml"},
    {"The same as a formula", "vcrit derive scenes/zener.toml"},
    {"Friction at half of it", "vcrit simulate scenes/zener.toml --velocity-ratio 0.5"},
    {"Cross-check everything and write a page: report/index.html",
     "vcrit validate scenes/elastic.toml --out report"},
};

const std::map<std::string, std::vector<Example>> command_examples{
    {"derive",
     {{"The formula with the lines that lead to it, and its limits",
       "vcrit derive scenes/elastic_drive.toml --limits"},
      {"For a paper, as an article that pdflatex compiles",
       "vcrit derive scenes/zener.toml --format latex --standalone"},
      {"As a rational function of omega^2", "vcrit derive scenes/kelvin.toml --form rational"},
      {"All named rheologies, as a page", "vcrit derive --catalogue > rheologies.html"}}},
    {"eval",
     {{"The critical velocity of a scene", "vcrit eval scenes/zener.toml"},
      {"With other values", "vcrit eval scenes/zener.toml --set \"frequency=25 kHz\" --set k0=9e6"},
      {"For a script", "vcrit eval scenes/zener.toml --json"}}},
    {"generate",
     {{"lib/pad.hpp and a CMakeLists.txt that tests it",
       "vcrit generate scenes/zener.toml --out lib --name pad"},
      {"A C header with all numbers of the scene folded in",
       "vcrit generate scenes/zener.toml --out lib --name pad --language c99 --fix all"}}},
    {"simulate",
     {{"At half the critical velocity", "vcrit simulate scenes/kelvin.toml --velocity-ratio 0.5"},
      {"Where the contact opens in each period",
       "vcrit simulate scenes/separation.toml --velocity-ratio 0.3"},
      {"Below a sphere, cell by cell", "vcrit simulate scenes/sphere.toml --velocity-ratio 0.5"},
      {"At a speed, from rest, by time stepping",
       "vcrit simulate scenes/kelvin.toml --velocity \"1 mm/s\" --start rest --method moreau"}}},
    {"critical",
     {{"Formula against simulation; exit status 1 if they differ",
       "vcrit critical scenes/kelvin.toml"}}},
    {"plot",
     {{"Friction over speed, on the terminal", "vcrit plot scenes/zener.toml"},
      {"v* over frequency, as a picture for a page",
       "vcrit plot scenes/zener.toml --over frequency --out frequency.svg"},
      {"Force and velocity over one period at 2 mm/s",
       "vcrit plot scenes/zener.toml --cycle --velocity \"2 mm/s\""}}},
    {"explore",
     {{"A page to move the parameters in", "vcrit explore scenes/zener.toml --out zener.html"}}},
    {"sweep",
     {{"The critical velocity over three decades of frequency",
       "vcrit sweep scenes/zener.toml --over \"frequency=log:1 kHz:1 MHz:31\" --quantity "
       "critical_velocity"},
      {"Friction over the speed",
       "vcrit sweep scenes/kelvin.toml --over velocity_ratio=lin:0.1:1:10 --quantity "
       "friction_ratio --out friction.csv"},
      {"A map of a million points for xarray, h5py or MATLAB; mpirun may stand before it, and "
       "--resume goes on with it after a kill",
       "vcrit sweep scenes/zener.toml --over \"frequency=log:1 kHz:1 MHz:1000\" --over "
       "k1=lin:1e6:8e6:1000 --quantity critical_velocity --out map.nc"}}},
    {"solve",
     {{"The smallest amplitude that halves friction at a speed",
       "vcrit solve scenes/zener.toml --for amplitude --friction-ratio 0.5 --velocity \"2 mm/s\""},
      {"Up to which speed a fifth of friction goes",
       "vcrit solve scenes/zener.toml --for velocity --friction-ratio 0.8"}}},
    {"fit",
     {{"A scene from measured storage and loss stiffness",
       "vcrit fit scenes/measured_pad.csv --out pad.toml"}}},
    {"new",
     {{"A polymer pad under a spring with a mass, to be filled in",
       "vcrit new my.toml --rheology zener --drive spring --mass"},
      {"To look at", "vcrit new --rheology kelvin"}}},
    {"check",
     {{"All that is wrong with a scene, or which commands answer for it",
       "vcrit check scenes/zener.toml"},
      {"Several scenes, for a script", "vcrit check scenes/kelvin.toml scenes/zener.toml --json"}}},
    {"validate",
     {{"A page for each scene and an index",
       "vcrit validate scenes/elastic.toml scenes/measured_drive.toml --out report"},
      {"Check the equations and figures of the paper", "vcrit validate --paper --out paper"}}},
};

std::string text_of(const std::vector<Example>& examples) {
  std::string text = "Examples:\n";
  for (const auto& [words, line] : examples) text += fmt::format("  {}:\n    {}\n", words, line);
  text.pop_back();
  return text;
}

}  // namespace

void add_examples(CLI::App& program) {
  program.footer(text_of(program_examples));
  for (const auto& [command, examples] : command_examples)
    program.get_subcommand(command)->footer(text_of(examples));
}

}  // namespace vcrit::app
