// Scenes of few words: what a test says of one, and the rest as usual.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace vcrit::test {

/// A value as a scene has it: numbers read back as they are, texts are quoted. By default no value.
class Toml {
 public:
  Toml() = default;
  Toml(const char* text) : Toml(std::string(text)) {}
  Toml(const std::string& text) : written_('"' + text + '"') {}
  Toml(bool value) : written_(value ? "true" : "false") {}
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) Toml(Number value)
      : written_(digits(value)) {}
  Toml(const std::vector<double>& values) {
    for (const double value : values) written_ += (written_.empty() ? "[" : ", ") + digits(value);
    written_ += "]";
  }

  /// "key = value" and the end of the line, or nothing.
  std::string line(const std::string& key) const {
    return written_.empty() ? "" : key + " = " + written_ + "\n";
  }

 private:
  template <class Number>
  static std::string digits(Number value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
  }

  std::string written_;
};

using Elements = std::vector<std::pair<std::string, Toml>>;

/// Keys as in the file. Without a tangential network or a ratio, Poisson's ratio is 0.3.
struct SceneText {
  Toml normal = "kn", tangential{}, poisson{}, tangential_ratio{}, separation{};
  std::string indenter{};  ///< lines of its section
  Toml network{}, receptance{};
  Toml mass{};
  Toml mount{}, mount_mass{};  ///< `network` and `mass` of [mount]
  Toml frequency{}, angular_frequency = 2, amplitude = 0.1, indentation = 1;
  Toml force{};  ///< of [load], in place of the indentation
  Toml coefficient = 0.5;
  Elements elements{};
  std::string more{};  ///< lines behind those of [elements]; more sections
};

inline std::string section(const std::string& name, const std::string& lines) {
  return lines.empty() ? "" : "[" + name + "]\n" + lines;
}

inline std::string to_toml(const SceneText& s) {
  const std::string given = s.tangential.line("tangential") + s.poisson.line("poisson") +
                            s.tangential_ratio.line("tangential_ratio");
  const std::string frequency = s.frequency.line("frequency"), force = s.force.line("force");
  std::string elements;
  for (const auto& [name, value] : s.elements) elements += value.line(name);
  return section("contact", s.normal.line("normal") + (given.empty() ? "poisson = 0.3\n" : given) +
                                s.separation.line("separation")) +
         section("indenter", s.indenter) +
         section("drive", s.network.line("network") + s.receptance.line("receptance")) +
         section("body", s.mass.line("mass")) +
         section("mount", s.mount.line("network") + s.mount_mass.line("mass")) +
         section("oscillation",
                 (frequency.empty() ? s.angular_frequency.line("angular_frequency") : frequency) +
                     s.amplitude.line("amplitude") +
                     (force.empty() ? s.indentation.line("indentation") : "")) +
         section("load", force) + section("friction", s.coefficient.line("coefficient")) +
         section("elements", elements) + s.more;
}

inline Scene scene_of(const SceneText& text, const Settings& settings = {}) {
  return parse_scene(to_toml(text), "s.toml", settings);
}

/// The surface creeps back so slowly that the contact is open where the indentation grows fastest:
/// v* is simulated.
inline SceneText slow_zener() {
  return {.normal = "zener(k0, k1, c1)",
          .tangential_ratio = 0.8,
          .separation = true,
          .angular_frequency = 1e5,
          .amplitude = 1e-6,
          .indentation = 4e-7,
          .coefficient = 0.3,
          .elements = {{"k0", 2e5}, {"k1", 2e6}, {"c1", 40}}};
}

/// The network "bridge" of k1, k2, k3, c1 and c2, which is no parallel or series combination.
inline const std::string bridge_network =
    "[networks.bridge]\nterminals = [\"a\", \"b\"]\n"
    "edges = [[\"k1\", \"a\", \"1\"], [\"c1\", \"a\", \"2\"], [\"k2\", \"1\", \"2\"], "
    "[\"c2\", \"1\", \"b\"], [\"k3\", \"2\", \"b\"]]\n";

/// What has still to be said: no number of the oscillation and of friction.
inline SceneText symbolic(SceneText text) {
  text.angular_frequency = text.amplitude = text.indentation = text.coefficient = {};
  return text;
}

}  // namespace vcrit::test
