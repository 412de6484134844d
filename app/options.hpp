// What several commands share: reading the scene, warnings, numbers in JSON.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace vcrit::app {

/// The scene file and its --set NAME=VALUE.
struct SceneOptions {
  std::string file;
  std::vector<std::string> settings;

  void add_to(CLI::App& command);
  /// Reads the scene; its warnings go to stderr.
  Scene read() const;
  Settings split_settings() const;
};

/// A number that reads back to the same double; "inf" for an infinite one.
nlohmann::ordered_json number(double value);

/// Prints one object on stdout.
void print(const nlohmann::ordered_json& object);

}  // namespace vcrit::app
