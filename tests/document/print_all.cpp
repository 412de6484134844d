// Prints everything that is derived and generated for some scenes, for the test that every run
// gives the same bytes.
#include <iostream>
#include <string>

#include "analysis/rational_form.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "document/findings.hpp"
#include "document/print.hpp"
#include "document/printed.hpp"
#include "emit/generate.hpp"
#include "formula/text.hpp"

namespace vcrit::test {

namespace {

void print_derivation(const Problem& scene) {
  using symbolic::Format;
  const symbolic::Findings all = symbolic::findings_of(scene, {Format::text, true, true});
  for (const Format format : {Format::text, Format::latex, Format::markdown, Format::html})
    std::cout << symbolic::print_findings(scene, all, format);
  std::cout << symbolic::print(scene, {Format::json, true, true});
  for (const auto form : {symbolic::ResultForm::nested, symbolic::ResultForm::dimensionless})
    std::cout << symbolic::print(scene, {Format::text, false, false, form});
  if (scene->receptance() == nullptr)
    std::cout << symbolic::print(scene,
                                 {Format::text, false, false, symbolic::ResultForm::storage_loss});
  for (const std::string& system : symbolic::system_names())
    std::cout << symbolic::print_findings(scene, all, Format::system, system);
  if (scene->receptance() == nullptr &&
      symbolic::terms_before_squaring(symbolic::SymbolicModel(scene)) < 300)
    std::cout << symbolic::print(scene,
                                 {Format::json, false, false, symbolic::ResultForm::rational});
  for (const symbolic::Line& line : symbolic::derive(scene).lines)
    std::cout << symbolic::to_mathml(line) << '\n';
}

}  // namespace

void print_all() {
  for (const Scene& scene :
       {kelvin_scene(), scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd | cd", "m"),
        scene_of("normal = \"burgers(k1, c1, k2, c2)\"\npoisson = \"nu\"", "kd", "m"),
        scene_of("normal = \"prony(k0, k, tau, 10)\"\ntangential = \"prony(k1, kt, taut, 2)\"",
                 "kd"),
        scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", bridge_network),
        scene_of("normal = \"bridge\"\ntangential_ratio = 0.7", "", "", bridge_network)}) {
    print_derivation(scene);
    const symbolic::Derivation derivation = symbolic::derive(scene);
    std::cout << symbolic::emit_header(derivation, "scene")
              << symbolic::emit_test(derivation, "scene");
  }
  const symbolic::GenerateOptions options{{"all"}, true};
  for (const char* file : {VCRIT_SCENES "/prony.toml", VCRIT_SCENES "/bridge.toml"}) {
    const symbolic::Derivation scene = symbolic::derive(read_scene(file));
    std::cout << symbolic::emit_header(scene, "scene", options)
              << symbolic::emit_quantities(scene, "scene")
              << symbolic::emit_test(scene, "scene", options);
  }
  // Drives that generated code does not know.
  print_derivation(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"",
                            "k2 - (mass(m2) | k3 | c3 | (k4 - mass(m4)))", "m"));
  print_derivation(read_scene(VCRIT_SCENES "/measured_drive.toml"));
}

}  // namespace vcrit::test
