// Scenes of the derivation's tests, from text.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace vcrit::test {

/// A scene without values; the parts are lines of the sections' bodies.
inline Scene scene_of(const std::string& contact, const std::string& drive = "",
                      const std::string& mass = "", const std::string& rest = "") {
  std::string text = "title = \"test\"\n[contact]\n" + contact + "\n";
  if (!drive.empty()) text += "[drive]\nnetwork = \"" + drive + "\"\n";
  if (!mass.empty()) text += "[body]\nmass = \"" + mass + "\"\n";
  return parse_scene(text + rest, "test.toml");
}

inline const std::string kelvin_contact = "normal = \"kn | cn\"\ntangential = \"kt | ct\"";
inline Scene kelvin_scene() { return scene_of(kelvin_contact, "kd", "m"); }

inline const std::string bridge_network =
    "[networks.bridge]\nterminals = [\"a\", \"b\"]\n"
    "edges = [[\"k1\", \"a\", \"1\"], [\"c1\", \"a\", \"2\"], [\"k2\", \"1\", \"2\"], "
    "[\"c2\", \"1\", \"b\"], [\"k3\", \"2\", \"b\"]]\n";

}  // namespace vcrit::test
