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

Scene SceneOptions::read(Frequency frequency) const {
  return read([frequency](const Scene&) { return frequency; });
}

Scene SceneOptions::read(const std::function<Frequency(const Scene&)>& frequency) const {
  Scene scene = read_scene(file, split_settings());
  const std::optional<double>& omega = scene.angular_frequency.value;
  if (frequency(scene) == Frequency::varied && omega)
    if (const auto own = beyond_fitted_range(scene, *omega, *omega))
      std::erase(scene.warnings, *own);
  for (const std::string& warning : scene.warnings) warn(warning);
  return scene;
}

nlohmann::ordered_json with_warnings(nlohmann::ordered_json object,
                                     const std::vector<std::string>& warnings) {
  if (!warnings.empty()) object["warnings"] = warnings;
  return object;
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
