// What lies behind Eq. 24, as a straight-line program: the stiffnesses as complex numbers, and with
// D = K_d - m omega^2 the amplitudes of (13) and (19),
//   body           A = -mu0 du_z K_n/D
//   contact point  B = -mu0 du_z K_n (K_t + D)/(K_t D),   under a rigid drive 1/D = 0,
// with du_z K_m/(K_m + K_n - m_n omega^2) in place of du_z where there is a mount.
// For doubles: K = T conj(Q)/|Q|^2 errs by a few roundings of |K|, its smaller part relatively
// more.
#pragma once

#include <optional>

#include "program/velocity.hpp"

namespace vcrit::symbolic {

struct StiffnessResult {
  ComplexNode k;
  /// The error of K is at most this many roundings (2^-53) of |K|; nothing where a mesh only knows
  /// at run time.
  std::optional<int> roundings;
  bool exact_re = false;         ///< Re K is a number as it was given
  bool may_be_infinite = false;  ///< where Q = 0: both parts are then NaN
};

/// x(t) = amplitude cos(omega t + phase) beside u_z = du_z cos(omega t)
struct OscillationResult {
  NodeId amplitude = 0;
  ComplexNode direction;  ///< of the phase; any length
};

struct QuantityProgram {
  Program program;
  StiffnessResult normal, tangential;
  std::optional<StiffnessResult> drive;     ///< none where it is rigid
  std::optional<StiffnessResult> mount;     ///< none without one
  std::optional<OscillationResult> body;    ///< none without a mass
  std::optional<OscillationResult> height;  ///< of the contact, beside U cos(omega t) of a vibrator
  OscillationResult contact_point;
  /// The amplitude that du_z has to stay below; none where K_n(0) = 0 and no load is given, and of
  /// an indenter under a load.
  std::optional<NodeId> largest_amplitude;
};

/// Elements are taken to lie within 2^-64 to 2^64, where nothing overflows. Throws ModelError like
/// velocity_program.
QuantityProgram quantity_program(const Problem& problem, const SymbolValue& value);

}  // namespace vcrit::symbolic
