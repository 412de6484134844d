// `--set NAME=VALUE` on a scene with a drive, a body and arrays. What is accepted is the scene that
// Variation makes with the same number, and v* is a number, infinity or an error.
#include <array>
#include <cmath>

#include "critical/certified.hpp"
#include "fuzz.hpp"
#include "problem/variants.hpp"
#include "problem/variation.hpp"
#include "scene/scene.hpp"
#include "scene/settings.hpp"
#include "support/scene_text.hpp"

using namespace vcrit;

namespace {

const test::SceneText settable{.normal = "prony(k0, k, tau)",
                               .poisson = "nu",
                               .network = "kd | cd",
                               .mass = 5e-3,
                               .frequency = "20 kHz",
                               .amplitude = 1e-7,
                               .indentation = 1e-6,
                               .coefficient = 0.3,
                               .elements = {{"k0", 1e6},
                                            {"k", std::vector{2e6, 3e6}},
                                            {"tau", std::vector{1e-6, 1e-5}},
                                            {"kd", 1e6},
                                            {"cd", 10}}};

void check_setting(const std::string& setting) {
  static const Scene plain = test::scene_of(settable);
  const auto [name, value] = parse_setting(setting);
  const Scene scene = test::scene_of(settable, {{name, value}, {"poisson", "0.25"}});
  const double number = parse_quantity(
      value, known_dimension(name, plain.settable, argument("set")), argument("set"));
  const double velocity = certified_critical_velocity(scene).value;
  fuzz::check(velocity >= 0, "v* is no NaN and not negative");
  if (name == "poisson" || name == "nu") return;
  const Variation varied(test::scene_of(settable, {{"poisson", "0.25"}}), {name});
  // With a unit what is read is a decimal number, and what is changed the double of it.
  const double read = certified_critical_velocity(as_doubles(scene)).value;
  const double changed =
      certified_critical_velocity(as_doubles(varied.at(std::array{number}))).value;
  fuzz::check(read == changed, "a setting read is a setting changed");
}

}  // namespace

void fuzz::read_setting(const std::string& text) {
  fuzz::answered([&] { check_setting(text); });
}
