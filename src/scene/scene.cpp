#include "scene/scene.hpp"

namespace vcrit {

Symbol as_called(const Scene& scene, const Symbol& symbol) {
  const auto name = scene.names.find(symbol.name);
  return name == scene.names.end() ? symbol : Symbol{name->second, symbol.entry};
}

double tangential_ratio(const Isotropic& isotropic) {
  if (!isotropic.quantity.value)
    throw InputError(argument(to_text(isotropic.quantity.symbol)), "no value", "a number");
  const double value = *isotropic.quantity.value;
  return isotropic.by == Isotropic::By::poisson ? 2 * (1 - value) / (2 - value) : value;
}

}  // namespace vcrit
