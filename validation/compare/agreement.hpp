// One scene, every way to its critical velocity against one reference: the certified value of
// Eq. 24 (correctly rounded) against plain doubles, the derived formula with 50 digits, the
// generated evaluator, the harmonic balance of the simulator's model, and the motion, which knows
// nothing of either (border.hpp).
#pragma once

#include "compare/scene_report.hpp"
#include "compare/witnesses.hpp"
#include "run/driver.hpp"
#include "run/progress.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// `driver` is the scene's, compiled here if there is a compiler; its derivation is what others are
/// asked for, `formula` the one that is compared. Throws InputError for missing values, ModelError
/// where Eq. 24 is 0/0. A scene that is not admissible is not simulated; its formulas are compared
/// all the same.
SceneReport agree(Driver& driver, const symbolic::Derivation& formula, const Progress& progress,
                  const Witnesses& witnesses = own_witnesses());

}  // namespace vcrit::validation
