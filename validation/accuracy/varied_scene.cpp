#include "accuracy/varied_scene.hpp"

namespace vcrit::validation::accuracy {

VariedScene::VariedScene(const Scene& scene) : scene_(scene) {
  for (auto& [symbol, value] : scene_.elements) places_[symbol] = &value;
  for (Quantity* quantity : {&scene_.coefficient, &scene_.angular_frequency, &scene_.amplitude,
                             &scene_.indentation, scene_.mass ? &*scene_.mass : nullptr})
    if (quantity != nullptr) places_[quantity->symbol] = &quantity->value;
}

}  // namespace vcrit::validation::accuracy
