// Eq. 24 as a straight-line program,
//   v* = mu0 omega du_z sqrt(above/below)   or, where no number is complex, mu0 omega du_z
//   above/below,
// with its error bound. With K_n = T_n/Q_n, K_t = T_t/Q_t and K_d = T_d/Q_d,
//   D = T_d - m omega^2 Q_d,  N = T_t Q_d + Q_t D,
//   |K_n| |K_t + K_d - m omega^2|/(|K_t| |K_d - m omega^2|) = |T_n| |N|/(|Q_n| |T_t| |D|).
// A drive with masses and a measured one have T_d and Q_d that may vanish (drive_pair.hpp).
#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"
#include "program/ratio.hpp"

namespace vcrit::symbolic {

struct VelocityProgram {
  Program program;
  NodeId above = 0, below = 0, factor = 0;
  bool rooted = false;
  NodeId roundings = 0;           ///< of v*, relative, each of the arithmetic's precision; a bound
  std::vector<Guard> guards;      ///< in which no number can leave the range of doubles
  bool fits = true;               ///< false: numbers folded in are too large for that
  int exponent = 0;               ///< elements lie between 2^-exponent and 2^exponent
  std::optional<Symbol> poisson;  ///< a parameter above -1, up to 1/2; all others are not negative
};

/// Throws ModelError for a scene of which no code is generated (rules/rulebook.hpp).
VelocityProgram velocity_program(const Problem& problem, const SymbolValue& value,
                                 Zeros zeros = Zeros::out_of_range);

}  // namespace vcrit::symbolic
