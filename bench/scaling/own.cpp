// vcrit's own ways.
#include <set>

#include "analysis/limits.hpp"
#include "analysis/sensitivities.hpp"
#include "derivation/derivation.hpp"
#include "derivation/stiffness_forms.hpp"
#include "formula/names.hpp"
#include "polynomial/network_polynomials.hpp"
#include "scaling/own.hpp"
#include "scene/scene.hpp"

namespace vcrit::scaling {

std::optional<double> straight_line(const ScalingCase& each) {
  return seconds_of([&] { reduce(each.network); });
}

std::optional<double> named_formula(const ScalingCase& each) {
  return seconds_of([&] {
    std::vector<symbolic::Line> definitions;
    symbolic::nested(reduce(each.network), {}, definitions);
  });
}

std::optional<double> multiplied_out(const ScalingCase& each) {
  std::set<std::string> names{symbolic::own_name("s")};
  for (const Symbol& symbol : symbols_of(each.network)) names.insert(to_text(symbol));
  return seconds_of([&] {
    const Ring ring({names.begin(), names.end()});
    symbolic::stiffness(each.network, ring);
  });
}

namespace {

/// The network as the contact, on a body that a spring drives.
Scene on_a_body(const ScalingCase& each) {
  Scene scene;
  scene.normal = each.network;
  scene.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, 0.8}};
  scene.drive = spring({"kd"});
  scene.mass = Quantity{{"m"}, {}};
  for (const Symbol& symbol : symbols_of(each.network))
    scene.elements.emplace_back(symbol, std::nullopt);
  return scene;
}

}  // namespace

double whole_derivation(const ScalingCase& each) {
  return seconds_of([&, scene = on_a_body(each)] { symbolic::derive(scene); });
}

double all_limits(const ScalingCase& each) {
  return seconds_of(
      [derivation = symbolic::derive(on_a_body(each))] { symbolic::limits(derivation); });
}

double all_sensitivities(const ScalingCase& each) {
  return seconds_of(
      [derivation = symbolic::derive(on_a_body(each))] { symbolic::sensitivities(derivation); });
}

}  // namespace vcrit::scaling
