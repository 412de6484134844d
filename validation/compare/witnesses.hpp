// Who is heard of v* besides the generated evaluator.
#pragma once

#include <functional>
#include <vector>

#include "compare/border.hpp"
#include "compare/scene_report.hpp"
#include "critical/certified.hpp"
#include "indenter/half_space.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// Who is heard besides the generated evaluator and the motion. Tests put false ones among them.
struct Witnesses {
  std::function<CertifiedVelocity(const Problem&)> certified;     ///< the reference
  std::function<double(const Problem&)> formula;                  ///< Eq. 24 in doubles, m/s
  std::function<simulation::System(const Problem&)> system;       ///< what is simulated
  std::function<indenter::HalfSpace(const Problem&)> half_space;  ///< the same below an indenter
  /// The simulator's own harmonic balance: from where on steady sliding exists.
  std::function<simulation::Onset(const simulation::System&)> balance;
  /// Another method marched just below and above v*.
  std::function<Comparison(const Border&, const simulation::System&)> march;
  /// Friction over speed by other methods, for the page alone: no comparison is made of it.
  std::function<std::vector<MethodCurve>(const simulation::System&, double)> curves;
};
Witnesses own_witnesses();

}  // namespace vcrit::validation
