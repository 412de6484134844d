// How a scene's networks answer harmonic forces, by nodal analysis of all of them at once in long
// doubles: no reduction, no K_d - m omega^2, nothing of Eq. 24 but each element's own law.
#pragma once

#include <complex>

#include "problem/problem.hpp"

namespace vcrit::validation {

using LongComplex = std::complex<long double>;

class NodalResponse {
 public:
  /// Throws InputError for missing values.
  explicit NodalResponse(const Problem& problem);

  /// Displacement (m) of the contact point for each newton on it at an angular frequency (rad/s),
  /// through contact, body and drive; not finite at an undamped resonance. A measured drive is
  /// rigid outside its table.
  LongComplex contact_point(double omega) const;
  /// The same of the contact under a body that stands still.
  LongComplex contact_alone(double omega) const;
  /// Force (N) of the normal network for each metre of indentation.
  LongComplex normal_stiffness(double omega) const;

 private:
  Problem problem_;
  Values values_;
};

}  // namespace vcrit::validation
