#include "problem/placing.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "problem/parts.hpp"
#include "scene/scene.hpp"

namespace vcrit {

namespace {

std::vector<Amount> expressions_of(const Resolved& parts) {
  std::vector<Amount> all;
  for_each_network(parts, [&all](const Network& network) {
    for_each_element(network, [&all](const Element& element) {
      for (const Amount* amount : {&element.coefficient, &element.second, &element.rest})
        if (!amount->is_symbol()) all.push_back(*amount);
    });
  });
  return all;
}

class Placing {
 public:
  explicit Placing(const Values& numbers) : numbers_(numbers) {}

  Resolved parts_of(const Scene& scene) const {
    Resolved parts{scene,
                   reduced(scene.normal),
                   tangential_of(scene),
                   drive_of(scene),
                   elements_of(scene),
                   typed_of(scene),
                   {},
                   std::make_shared<const Source>(scene),
                   {},
                   {}};
    if (scene.mount) parts.mount = reduced(*scene.mount);
    if (const auto typed = scene.typed.find(frequency_symbol); typed != scene.typed.end())
      parts.frequency = typed->second;
    parts.expressions = expressions_of(parts);
    place(parts.indentation.symbol);
    if (parts.mount_mass) place(parts.mount_mass->symbol);
    for_each_quantity(parts, [this](Quantity& quantity) { place(quantity.symbol); });
    for (MeasuredStiffness& measured : parts.measured)
      for (Symbol* symbol : {&measured.storage, &measured.loss_factor, &measured.rest})
        place(*symbol);
    return parts;
  }

 private:
  void place(Symbol& symbol) const { symbol = numbers_.placed(symbol); }

  ReducedNetwork reduced(Network network) const {
    rename(network, [this](const Symbol& symbol) { return numbers_.placed(symbol); });
    return ReducedNetwork(std::move(network));
  }

  std::variant<Rigid, ReducedNetwork, Receptance> drive_of(const Scene& scene) const {
    if (scene.receptance) return *scene.receptance;
    if (scene.drive) return reduced(*scene.drive);
    return Rigid{};
  }

  std::variant<Isotropic, ReducedNetwork> tangential_of(const Scene& scene) const {
    if (const auto* own = std::get_if<Network>(&scene.tangential)) return reduced(*own);
    return std::get<Isotropic>(scene.tangential);
  }

  std::shared_ptr<const std::vector<Symbol>> elements_of(const Scene& scene) const {
    auto elements = std::make_shared<std::vector<Symbol>>();
    for (const auto& [symbol, value] : scene.elements) elements->push_back(numbers_.placed(symbol));
    return elements;
  }

  std::shared_ptr<const BySymbol<TypedNumber>> typed_of(const Scene& scene) const {
    auto typed = std::make_shared<BySymbol<TypedNumber>>(BySymbol<TypedNumber>::beside(numbers_));
    for (const auto& [symbol, number] : scene.typed)
      if (symbol != frequency_symbol) typed->emplace(symbol, number);
    return typed;
  }

  const Values& numbers_;
};

}  // namespace

Values element_numbers(const Scene& scene) {
  std::vector<Symbol> all{scene.indentation.symbol};
  for (const auto& [symbol, value] : scene.elements) all.push_back(symbol);
  for_each_quantity(scene, [&all](const Quantity& quantity) { all.push_back(quantity.symbol); });
  for (const auto& [symbol, number] : scene.typed)
    if (symbol != frequency_symbol) all.push_back(symbol);
  Values numbers{SymbolList(std::move(all))};
  for (const auto& [symbol, value] : scene.elements)
    if (value) numbers[symbol] = *value;
  return numbers;
}

Resolved placed_parts(const Scene& scene, const Values& numbers) {
  return Placing(numbers).parts_of(scene);
}

}  // namespace vcrit
