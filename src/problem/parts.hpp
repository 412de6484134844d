// What a scene and a problem consist of, visited: the same for both where both have it.
#pragma once

#include <optional>
#include <variant>

#include "problem/problem.hpp"

namespace vcrit {

/// What moves with the contact along the normal may be the body, which also moves along the
/// surface.
inline bool shares_mass(const Givens& parts) {
  return parts.mass && parts.mount_mass && parts.mass->symbol == parts.mount_mass->symbol;
}

/// use(quantity) for each that has a name of its own.
template <class AnyParts, class Use>
void for_each_quantity(AnyParts& parts, const Use& use) {
  auto* isotropic = std::get_if<Isotropic>(&parts.tangential);
  if (isotropic != nullptr && !isotropic->quantity.symbol.name.empty()) use(isotropic->quantity);
  use(parts.coefficient);
  use(parts.angular_frequency);
  use(parts.amplitude);
  use(parts.load ? *parts.load : parts.indentation);
  if (parts.mass) use(*parts.mass);
  if (parts.mount_mass && !shares_mass(parts)) use(*parts.mount_mass);
  if (parts.indenter)
    for (auto& size : parts.indenter->sizes) use(size);
}

/// Its networks: normal, tangential, drive, mount.
template <class Use>
void for_each_network(const Resolved& parts, const Use& use) {
  use(parts.normal.network());
  if (const auto* own = std::get_if<ReducedNetwork>(&parts.tangential)) use(own->network());
  if (const auto* drive = parts.drive_network()) use(drive->network());
  if (parts.mount) use(parts.mount->network());
}

}  // namespace vcrit
