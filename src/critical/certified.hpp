// Eq. 24 correctly rounded: balls of adaptive precision around the scene's doubles, until they
// round to one double.
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace vcrit {

struct CertifiedVelocity {
  double value = 0;                 ///< m/s; infinite at resonance and above the largest double
  double relative_error_bound = 0;  ///< of `value`; 0 for exact answers, infinite for an overflow
  std::string reason;               ///< why the value is infinite, else empty
};

/// Of the scene's numbers as they were typed with a unit (20 kHz is 2 pi f, 0.1 um is 1e-7 m),
/// where these are still its values; bare numbers, and what is changed after reading, are doubles.
/// Throws ModelError for 0/0 (resonance and antiresonance at once) and outside the table of a
/// measured drive.
CertifiedVelocity certified_critical_velocity(const Problem& problem);

/// (p/v*) dv*/dp to the last digits, by differences in hundreds of bits. Throws ModelError where v*
/// is 0 or infinite, too.
double certified_log_derivative(const Problem& problem, const Symbol& symbol);

/// |ln v*_a - ln v*_b| of scenes with values, where it is not 0 in 4096 bits; else 0.
double certified_difference(const Problem& a, const Problem& b);

}  // namespace vcrit
