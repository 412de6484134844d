// Eq. (24) as a real expression: v* = P |K_n|/|K_t| |K_t + D|/|D|, D = K_d - m omega^2, in the
// ways in which networks and Eq. (24) can be written. A mount adds the factor
// |K_m|/|K_m + K_n - m_n omega^2|.
#pragma once

#include <optional>
#include <vector>

#include "network/network.hpp"
#include "shortest/presentations.hpp"

namespace vcrit::symbolic::shortest {

/// What v* is made of. A rigid drive is none, and has no mass; an isotropic contact has a ratio.
struct Parts {
  const Network* normal = nullptr;
  const Network* tangential = nullptr;  ///< of its own
  const Network* drive = nullptr;
  const Network* mount = nullptr;  ///< U in place of du_z; with the mass that moves with it
  std::optional<Ex> mass, mount_mass;
  Ex ratio;      ///< g = K_n/K_t of an isotropic contact
  Ex prefactor;  ///< mu0 omega du_z
  Ex omega;
};

std::vector<Ex> critical_velocities(Expressions& all, Presentations& presentations,
                                    const Parts& parts);

}  // namespace vcrit::symbolic::shortest
