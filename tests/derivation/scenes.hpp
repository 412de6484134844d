// Scenes of the derivation's tests, from text.
#pragma once

#include <string>

#include "scene/scene.hpp"
#include "support/scene_text.hpp"

namespace vcrit::test {

/// A scene without values; the parts are lines of the sections' bodies.
inline Scene scene_of(const std::string& contact, const std::string& drive = "",
                      const std::string& mass = "", const std::string& rest = "") {
  const auto given = [](const std::string& text) { return text.empty() ? Toml() : Toml(text); };
  return parse_scene("title = \"test\"\n" + section("contact", contact + "\n") +
                         section("drive", given(drive).line("network")) +
                         section("body", given(mass).line("mass")) + rest,
                     "test.toml");
}

inline const std::string kelvin_contact = "normal = \"kn | cn\"\ntangential = \"kt | ct\"";
inline Scene kelvin_scene() { return scene_of(kelvin_contact, "kd", "m"); }

/// Elements for k0, k1, c1, the entries of k, and kd, in terms of k0, k5, kc, r and t0.
inline const std::string made_of_others =
    "[elements]\nk1 = \"0.7*k0*r^2\"\nc1 = \"(k1 + kd/3)*tau\"\ntau = \"t0/(1 + r)\"\n"
    "k = [\"3*k0\", \"k1 + k5\"]\nkd = \"0.3*kc\"\n";
inline Scene scene_of_others() {
  return scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"k5 | generalized_kelvin(k, t, 2)\"",
                  "kd | cd", "m", made_of_others);
}

}  // namespace vcrit::test
