// Eq. 24 for sweeps over omega: T and Q of the networks as polynomials in s = i omega, whose
// coefficients the other parameters give once for all.
//
// Without error bound, so it is used only where it can be checked against the other program's, and
// only where cancellation costs little. The coefficients of T and Q are positive and the roots real
// and negative, so that the terms of a polynomial of degree n add up to at most 2^(n/2) times its
// absolute value. This is kept below 2^5:
//   even and odd powers apart, by Horner's rule in omega^2: n <= 10;
//   |T|^2 as one polynomial in omega^2: its coefficients are positive, but differences of products,
//   which errs by up to 2^n: n <= 5.
// D = T_d + m s^2 Q_d and N = T_t Q_d + Q_t D, multiplied out, have positive coefficients, too, and
// their terms add up to 2^(n/2) times (|K_d| + m omega^2)|Q_d| and (|K_t| + |K_d| + m omega^2)
// |Q_t Q_d|: near (anti)resonance they magnify errors 2^(n/2) times as much as any error of the
// parameters is magnified. The D of an elastic drive is formed without loss.
#pragma once

#include <optional>

#include "program/ratio.hpp"
#include "program/velocity.hpp"

namespace vcrit::symbolic {

struct SweepProgram : VelocityProgram {
  int least_omega = 0;  ///< good from 2^least_omega on
  int least_square =
      0;  ///< and for `above` and `below` from 2^least_square on, to 2^1024 times that
};

/// Nothing where that is not less work than `single`, the program of one v* of the scene.
std::optional<SweepProgram> sweep_program(const Problem& problem, const SymbolValue& value,
                                          const VelocityProgram& single);

}  // namespace vcrit::symbolic
