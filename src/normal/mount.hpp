// What a mount leaves of the vibrator's amplitude at the contact,
//   A_z = U K_m/(K_m + K_n - m_n omega^2),   du_z = |A_z|,
// while the contact stays closed.
#pragma once

#include <complex>

#include "problem/problem.hpp"

namespace vcrit {

/// A_z/U at omega (rad/s); 1 without a mount. Infinite in an undamped resonance of the mount.
/// Throws InputError for missing values.
std::complex<long double> mount_response(const Problem& problem, double omega);

/// du_z, m: of the contact, at the scene's frequency.
double contact_amplitude(const Problem& problem);

/// arg A_z, rad, below 0 where the contact is behind the vibrator. In an undamped resonance that of
/// vanishing damping, -pi/2.
double mount_phase(const Problem& problem);

/// |A_z/U|, as a double.
double mount_factor(const Problem& problem, double omega);

}  // namespace vcrit
