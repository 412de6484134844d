// Eq. (24), once:
//   v* = mu0 omega du_z |K_n|/|K_t| |K_t + D|/|D|,   D = K_d - m omega^2,
// what of it a scene has. Under a rigid drive the last quotient is 1; in an isotropic contact,
// K_t = r K_n, the first is 1/r, and K_n counts only where the drive gives.
#pragma once

#include "scene/scene.hpp"

namespace vcrit {

/// In an algebra, which gives
///   outer()                              mu0 omega du_z, with which v* begins
///   ratio(isotropic), normal(), tangential()      r, K_n, and K_t of a network of its own
///   scaled(ratio, normal)                r K_n
///   divide(v, ratio)                     v = v/r
///   times_quotient(v, normal, tangential)         v = v |K_n|/|K_t|
///   times_drive(v, tangential)           v = v |K_t + D|/|D|
template <class Algebra>
auto eq24(const Scene& scene, Algebra&& algebra) {
  auto v = algebra.outer();
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential)) {
    const auto ratio = algebra.ratio(*isotropic);
    algebra.divide(v, ratio);
    if (has_drive(scene)) algebra.times_drive(v, algebra.scaled(ratio, algebra.normal()));
    return v;
  }
  const auto normal = algebra.normal();
  const auto tangential = algebra.tangential();
  algebra.times_quotient(v, normal, tangential);
  if (has_drive(scene)) algebra.times_drive(v, tangential);
  return v;
}

}  // namespace vcrit
