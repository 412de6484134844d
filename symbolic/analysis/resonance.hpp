// Resonance and antiresonance of a scene with a mass, and the resonance of a mount, as equations in
// its symbols.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <vector>

#include "analysis/abbreviations.hpp"
#include "derivation/derivation.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// Where one factor of v*, condition = 0, makes it infinite or zero.
struct Resonance {
  /// resonance: v* infinite. antiresonance: v* = 0. mount_resonance: along the normal, where the
  /// contact's amplitude is infinite, and v* with it.
  enum class Kind { resonance, antiresonance, mount_resonance } kind = Kind::resonance;
  Expression condition;  ///< K_d - m omega^2, say
  /// Dampers keep |condition| above 0 at every frequency, unless
  bool damped = false;
  bool absorbing = false;  ///< masses of the drive keep them still at one of their own.
  std::optional<Expression> frequency;  ///< the omega at which the condition holds, without dampers
  /// With dampers, where short enough: real and imaginary part of the condition, both times one
  /// positive number.
  struct Parts {
    Expression real, imaginary;
  };
  std::optional<Parts> parts;
  std::vector<Line> definitions;  ///< of what condition and frequency name, as in Derivation
};

/// In the order of Kind; nothing for a scene without a mass. Conditions and parts that are short
/// enough are written in g and Z where these make them shorter, each times some positive number.
std::vector<Resonance> resonances(const Derivation& derivation, const Abbreviations& names = {});

}  // namespace vcrit::symbolic
