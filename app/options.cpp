#include "options.hpp"

#include <fmt/core.h>

#include <cmath>

#include "streams.hpp"

#include "scene/settings.hpp"

namespace vcrit::app {

void SceneOptions::add_to(CLI::App& command) {
  command.add_option("SCENE", file, "scene file (TOML)")->required();
  // One value an option, so that a scene may follow.
  command
      .add_option("--set", settings,
                  "give or replace a value: k0=8e6, \"frequency=25 kHz\", k[3]=1e5")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

Settings SceneOptions::split_settings() const {
  Settings result;
  for (const std::string& text : settings) result.push_back(parse_setting(text));
  return result;
}

Scene SceneOptions::read() const {
  Scene scene = read_scene(file, split_settings());
  for (const std::string& warning : scene.warnings) tell_line("vcrit: warning: " + warning);
  return scene;
}

nlohmann::ordered_json json_number(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

void print(const nlohmann::ordered_json& object) {
  // Names of files may be no UTF-8.
  fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace vcrit::app
