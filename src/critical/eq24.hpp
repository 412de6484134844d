// Eq. (24), once:
//   v* = mu0 omega du_z |K_n|/|K_t| |K_t + D|/|D|,   D = K_d - m omega^2,
//   du_z = U |K_m|/|K_m + K_n - m_n omega^2|,
// what of it a scene has; without a mount du_z is given. Under a rigid drive the last quotient is
// 1; in an isotropic contact, K_t = r K_n, the first is 1/r, and K_n counts only where the drive
// gives or there is a mount.
#pragma once

#include "problem/problem.hpp"

namespace vcrit {

/// In an algebra, which gives
///   outer()                              mu0 omega du_z (with a mount mu0 omega U)
///   ratio(isotropic), normal(), tangential(own)   r, K_n, and K_t of a network of its own
///   scaled(ratio, normal)                r K_n
///   times_mount(v, normal, mount)        v = v |K_m|/|K_m + K_n - m_n omega^2|, first of all
///   divide(v, ratio)                     v = v/r
///   times_quotient(v, normal, tangential)         v = v |K_n|/|K_t|
///   times_drive(v, tangential, drive)    v = v |K_t + D|/|D|, of a network and of a Receptance
template <class Algebra>
auto eq24(const Problem& problem, Algebra&& algebra) {
  auto v = algebra.outer();
  const auto times_drive = [&](const auto& tangential) {
    std::visit(
        Overloaded{[](const Rigid&) {},
                   [&](const ReducedNetwork& drive) { algebra.times_drive(v, tangential, drive); },
                   [&](const Receptance& drive) { algebra.times_drive(v, tangential, drive); }},
        problem->drive);
  };
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential)) {
    const auto ratio = algebra.ratio(*isotropic);
    if (problem->mount) {
      const auto normal = algebra.normal();
      algebra.times_mount(v, normal, *problem->mount);
      algebra.divide(v, ratio);
      if (!problem->rigid()) times_drive(algebra.scaled(ratio, normal));
      return v;
    }
    algebra.divide(v, ratio);
    if (!problem->rigid()) times_drive(algebra.scaled(ratio, algebra.normal()));
    return v;
  }
  const auto normal = algebra.normal();
  const auto tangential = algebra.tangential(std::get<ReducedNetwork>(problem->tangential));
  if (problem->mount) algebra.times_mount(v, normal, *problem->mount);
  algebra.times_quotient(v, normal, tangential);
  times_drive(tangential);
  return v;
}

}  // namespace vcrit
