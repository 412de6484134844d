// Prints everything that is derived and generated for some scenes, for the test that every run
// gives the same bytes.
#include <iostream>

#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "document/print.hpp"
#include "emit/generate.hpp"
#include "formula/text.hpp"

int main() {
  using namespace vcrit;
  using test::scene_of;
  for (const Scene& scene :
       {test::kelvin_scene(),
        scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd | cd", "m"),
        scene_of("normal = \"burgers(k1, c1, k2, c2)\"\npoisson = \"nu\"", "kd", "m"),
        scene_of("normal = \"prony(k0, k, tau, 10)\"\ntangential = \"prony(k1, kt, taut, 2)\"",
                 "kd"),
        scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network),
        scene_of("normal = \"bridge\"\ntangential_ratio = 0.7", "", "", test::bridge_network)}) {
    using symbolic::Format;
    for (const Format format : {Format::text, Format::latex, Format::markdown, Format::json})
      std::cout << symbolic::print(scene, format, true, true);
    for (const symbolic::Line& line : symbolic::derive(scene).lines)
      std::cout << symbolic::to_mathml(line) << '\n';
    std::cout << symbolic::emit_header(scene, "scene") << symbolic::emit_test(scene, "scene");
  }
}
