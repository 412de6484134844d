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
  Toml(const std::string& text);
  Toml(bool value) : written_(value ? "true" : "false") {}
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) Toml(Number value)
      : written_(digits(value)) {}
  Toml(const std::vector<double>& values);

  /// "key = value" and the end of the line, or nothing.
  std::string line(const std::string& key) const;

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

std::string section(const std::string& name, const std::string& lines);

std::string to_toml(const SceneText& text);

Scene scene_of(const SceneText& text, const Settings& settings = {});

/// The surface creeps back so slowly that the contact is open where the indentation grows fastest:
/// v* is simulated.
SceneText slow_zener();

/// The network "bridge" of k1, k2, k3, c1 and c2, which is no parallel or series combination.
inline const std::string bridge_network =
    "[networks.bridge]\nterminals = [\"a\", \"b\"]\n"
    "edges = [[\"k1\", \"a\", \"1\"], [\"c1\", \"a\", \"2\"], [\"k2\", \"1\", \"2\"], "
    "[\"c2\", \"1\", \"b\"], [\"k3\", \"2\", \"b\"]]\n";

/// What has still to be said: no number of the oscillation and of friction.
SceneText symbolic(SceneText text);

}  // namespace vcrit::test
