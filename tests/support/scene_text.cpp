#include "support/scene_text.hpp"

namespace vcrit::test {

Toml::Toml(const std::string& text) : written_('"' + text + '"') {}

Toml::Toml(const std::vector<double>& values) {
  for (const double value : values) written_ += (written_.empty() ? "[" : ", ") + digits(value);
  written_ += "]";
}

std::string Toml::line(const std::string& key) const {
  return written_.empty() ? "" : key + " = " + written_ + "\n";
}

std::string section(const std::string& name, const std::string& lines) {
  return lines.empty() ? "" : "[" + name + "]\n" + lines;
}

std::string to_toml(const SceneText& s) {
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

Scene scene_of(const SceneText& text, const Settings& settings) {
  return parse_scene(to_toml(text), "s.toml", settings);
}

SceneText slow_zener() {
  return {.normal = "zener(k0, k1, c1)",
          .tangential_ratio = 0.8,
          .separation = true,
          .angular_frequency = 1e5,
          .amplitude = 1e-6,
          .indentation = 4e-7,
          .coefficient = 0.3,
          .elements = {{"k0", 2e5}, {"k1", 2e6}, {"c1", 40}}};
}

SceneText symbolic(SceneText text) {
  text.angular_frequency = text.amplitude = text.indentation = text.coefficient = {};
  return text;
}

}  // namespace vcrit::test
