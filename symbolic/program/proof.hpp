// Programs held against the derivation. Both are evaluated over residues modulo a large prime, at
// points where the symbols have values that nobody chose: two different functions agree there with
// a chance of less than 1e-20 (analysis/residues.hpp). So what is compiled is what is printed.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "derivation/derivation.hpp"
#include "program/gradient.hpp"
#include "program/quantities.hpp"

namespace vcrit::symbolic {

class Proof {
 public:
  /// value: what the programs compute with, as it was given to them.
  Proof(const Derivation& derivation, const SymbolValue& value);

  /// Each throws Bug where there is a difference to the harmonic balance of the scene: in v*, for
  /// a formula that is printed and for a program,
  void holds(const Derivation& derivation) const;
  void holds(const VelocityProgram& velocity) const;
  /// in v* and its derivative along a direction that nobody chose,
  void holds(const GradientProgram& gradient) const;
  /// in stiffnesses, amplitudes, phases and the largest amplitude.
  void holds(const QuantityProgram& quantities) const;

 private:
  Problem problem_;
  std::shared_ptr<const SymbolicModel> model_;  ///< the ratio of an isotropic contact is a symbol
  std::map<std::string, GiNaC::numeric> fixed_;
  std::optional<double> ratio_;
  std::string ratio_name_;
};

}  // namespace vcrit::symbolic
