// A scene whose numbers can be set again and again without copying it.
#pragma once

#include <map>
#include <optional>

#include "scene/scene.hpp"

namespace vcrit::validation::accuracy {

class VariedScene {
 public:
  explicit VariedScene(const Scene& scene);
  VariedScene(const VariedScene&) = delete;
  VariedScene& operator=(const VariedScene&) = delete;

  /// SI; the symbol is one of the scene's quantities or elements.
  void set(const Symbol& symbol, double value) { *places_.at(symbol) = value; }
  bool has(const Symbol& symbol) const { return places_.contains(symbol); }
  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
  std::map<Symbol, std::optional<double>*> places_;
};

}  // namespace vcrit::validation::accuracy
