// The harmonic balance of body and contact point: equations of motion, harmonic ansatz, (13) and
// (19), solved for the amplitudes by GiNaC.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "formula/line.hpp"

namespace vcrit::symbolic {

/// What is there besides the contact. The stiffnesses are the quantities K_n, K_t, K_d of s.
struct Surrounding {
  bool drive = false;
  bool mass = false;  ///< only with a drive
};

struct Balance {
  std::vector<Line> lines;
  GiNaC::ex body_amplitude;     ///< A, likewise; 0 under a rigid drive
  GiNaC::ex contact_amplitude;  ///< B, a rational function of K_n, K_t, K_d, s and the symbols
  GiNaC::ex general_amplitude;  ///< B for any receptance H of the contact point (m/N)
};

/// Solved once for each kind of scene.
const Balance& solve_balance(const Surrounding& surrounding);

}  // namespace vcrit::symbolic
