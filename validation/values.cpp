#include "values.hpp"

#include "formula/symbols.hpp"
#include "formulas.hpp"

namespace vcrit::validation {

namespace {

struct ValueKind {
  const char* unit;
  const char* meaning;
};

void visit_elements(const Scene& scene, const std::function<void(const Element&)>& visit) {
  for_each_element(scene.normal, visit);
  if (const auto* tangential = std::get_if<Network>(&scene.tangential))
    for_each_element(*tangential, visit);
  if (scene.drive) for_each_element(*scene.drive, visit);
}

std::map<Symbol, ValueKind> kinds_of_elements(const Scene& scene) {
  std::map<Symbol, ValueKind> kinds;
  const char* const spring = scene.indenter ? "Pa" : "N/m";
  const char* const damper = scene.indenter ? "Pa s" : "N s/m";
  visit_elements(scene, [&](const Element& element) {
    switch (element.kind) {
      case ElementKind::spring:
        kinds[element.coefficient] = {spring, "spring"};
        break;
      case ElementKind::damper:
        kinds[element.coefficient] = {damper, "damper"};
        break;
      case ElementKind::maxwell:
        kinds[element.coefficient] = {spring, "spring of a Maxwell branch"};
        kinds[element.time] = {"s", "relaxation time of a Maxwell branch"};
        break;
      case ElementKind::mass:
        kinds[element.coefficient] = {"kg", "mass in the drive"};
        break;
    }
  });
  return kinds;
}

}  // namespace

std::vector<ValueLine> value_lines(const Scene& scene) {
  const Values values = values_of(scene);
  std::vector<ValueLine> lines;
  const auto add = [&](const Symbol& symbol, const ValueKind& kind) {
    const Formula name = formula_of(symbolic::symbol(symbol));
    lines.push_back({symbol, name, values.at(symbol), kind.unit, kind.meaning});
  };
  add(scene.angular_frequency.symbol, {"rad/s", "angular frequency"});
  add(scene.amplitude.symbol, {"m", "amplitude of the normal oscillation"});
  add(scene.indentation.symbol, {"m", "mean indentation"});
  add(scene.coefficient.symbol, {"", "coefficient of friction"});
  if (scene.mass) add(scene.mass->symbol, {"kg", "mass of the body"});
  if (scene.indenter)
    for (const Quantity& size : scene.indenter->sizes)
      add(size.symbol, {si_unit(scene.settable.at(size.symbol.name)), "size of the indenter"});
  const auto kinds = kinds_of_elements(scene);
  for (const auto& [symbol, value] : scene.elements)
    if (const auto kind = kinds.find(symbol); kind != kinds.end()) add(symbol, kind->second);
  return lines;
}

}  // namespace vcrit::validation
