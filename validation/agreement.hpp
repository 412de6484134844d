// One scene, every way to its critical velocity against one reference: the certified value of
// Eq. 24 (correctly rounded) against plain doubles, the derived formula with 50 digits, the
// generated evaluator, and the simulation, which knows nothing of Eq. 24.
#pragma once

#include <functional>
#include <string>

#include "driver.hpp"
#include "progress.hpp"
#include "scene_report.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// Who is heard against the certified value besides the generated evaluator. Tests put a false one
/// among them.
struct Witnesses {
  std::function<double(const Scene&)> formula;                   ///< Eq. 24 in doubles, m/s
  std::function<symbolic::Derivation(const Scene&)> derivation;  ///< the generator has its own
  std::function<simulation::System(const Scene&)> system;        ///< what is simulated
};
Witnesses own_witnesses();

/// Throws InputError for missing values, ModelError where Eq. 24 is 0/0. A scene that is not
/// admissible is not simulated; its formulas are compared all the same.
/// `driver` is the scene's, compiled here if there is a compiler.
SceneReport agree(const Scene& scene, Driver& driver, const Progress& progress,
                  const Witnesses& witnesses = own_witnesses());

}  // namespace vcrit::validation
