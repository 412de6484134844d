// One scene, every way to its critical velocity against one reference: the certified value of
// Eq. 24 (correctly rounded) against plain doubles, the derived formula with 50 digits, the
// generated evaluator, the harmonic balance of the simulator's model, and the motion, which knows
// nothing of either (border.hpp).
#pragma once

#include <functional>
#include <string>

#include "border.hpp"
#include "critical/certified.hpp"
#include "driver.hpp"
#include "progress.hpp"
#include "scene_report.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// Who is heard besides the generated evaluator and the motion. Tests put false ones among them.
struct Witnesses {
  std::function<CertifiedVelocity(const Scene&)> certified;  ///< the reference
  std::function<double(const Scene&)> formula;               ///< Eq. 24 in doubles, m/s
  std::function<simulation::System(const Scene&)> system;    ///< what is simulated
  /// The simulator's own harmonic balance: from where on steady sliding exists.
  std::function<simulation::Onset(const simulation::System&)> balance;
  /// Another method marched just below and above v*.
  std::function<Comparison(const Border&, const simulation::System&)> march;
};
Witnesses own_witnesses();

/// `driver` is the scene's, compiled here if there is a compiler; its derivation is what others are
/// asked for, `formula` the one that is compared. Throws InputError for missing values, ModelError
/// where Eq. 24 is 0/0. A scene that is not admissible is not simulated; its formulas are compared
/// all the same.
SceneReport agree(Driver& driver, const symbolic::Derivation& formula, const Progress& progress,
                  const Witnesses& witnesses = own_witnesses());

}  // namespace vcrit::validation
