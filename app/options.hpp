// What several commands share: reading the scene, numbers of options, printing an object.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace CLI {
class App;
}

namespace vcrit::app {

/// The scene file and its --set NAME=VALUE.
struct SceneOptions {
  std::string file;
  std::vector<std::string> settings;

  void add_to(CLI::App& command);
  /// Reads the scene; its warnings go to stderr. Where the command varies the frequency, that of
  /// the scene is not warned of.
  enum class Frequency { of_the_scene, varied };
  Problem read(Frequency frequency = Frequency::of_the_scene) const;
  Problem read(const std::function<Frequency(const Problem&)>& frequency) const;
  Settings split_settings() const;
};

/// "0.5" or "50%", of that option. Throws InputError, which says what was `expected`.
double ratio_of(const std::string& text, const char* option, const char* expected);

/// The same of --velocity-ratio.
double speed_ratio_of(const std::string& text);

/// --digits of the numbers in what people read.
void add_digits(CLI::App& command, int& digits);

/// A line of what people read: "  heading             text"; nothing without a text.
void print_row(const std::string& heading, const std::string& text);

/// Prints one object on stdout: what record::json_of makes of a command's result.
void print(const nlohmann::ordered_json& object);

}  // namespace vcrit::app
