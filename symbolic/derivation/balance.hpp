// The harmonic balance of body and contact point: equations of motion, harmonic ansatz, (13) and
// (19), solved for the amplitudes by GiNaC.
#pragma once

#include <ginac/ginac.h>

#include <compare>
#include <vector>

#include "formula/line.hpp"

namespace vcrit::symbolic {

/// What is there besides the contact. The stiffnesses are the quantities K_n, K_t, K_d of s.
struct Surrounding {
  bool drive = false;
  bool mass = false;  ///< only with a drive
  /// The vibrator presses through K_m. Then U stands in the place of du_z, which is |A_z|.
  bool mount = false;
  /// What moves with the contact along the normal: nothing, m_n, or the body's own m.
  enum class NormalMass { none, own, body } normal_mass = NormalMass::none;

  friend auto operator<=>(const Surrounding&, const Surrounding&) = default;
};

struct Balance {
  std::vector<Line> lines;
  GiNaC::ex body_amplitude;     ///< A, likewise; 0 under a rigid drive
  GiNaC::ex contact_amplitude;  ///< B, a rational function of K_n, K_t, K_d, s and the symbols
  GiNaC::ex general_amplitude;  ///< B for any receptance H of the contact point (m/N)
  GiNaC::ex normal_amplitude;   ///< A_z of the contact along the normal; du_z without a mount
};

/// Solved once for each kind of scene.
const Balance& solve_balance(const Surrounding& surrounding);

}  // namespace vcrit::symbolic
