// Bodies so near an undamped resonance with their drive that the swing of steady sliding, from
// which motions are told, is lost in rounding, or infinite. The cycle of stick and slip is none of
// that: as long as the drive is slower than v*, stick bounds the swing, and all that the cycle has
// is an analytic function of the drive's stiffness through the resonance. So it is taken from
// drives that are a little softer and stiffer.
#pragma once

#include <array>

#include "simulation/motion/model.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::simulation {

/// Whether rounding errors grow too much for motions to be told from steady sliding.
bool lost_in_resonance(const Model& model);

/// Systems with drives of other stiffness. Their answers f, so weighed, differ from that of the
/// system by O(step^4); near[0] and near[1] are as far softer and stiffer as the others half.
struct Neighbours {
  double step = 0;  ///< of the stiffness, as a share of that over which the motion changes
  std::array<System, 4> systems;

  static constexpr std::array<double, 4> weights{4. / 6, 4. / 6, -1. / 6, -1. / 6};

  double mean(const std::array<double, 4>& f) const;
  /// Of that mean, beside the errors of the four.
  double error(const std::array<double, 4>& f) const;
};

/// Throws ModelError: the motion is so fast that no neighbour is far enough from the resonance.
[[noreturn]] void too_fast_for_neighbours();

/// velocity: of a motion of the model, below its threshold. Throws ModelError as above; a neighbour
/// may still be lost in resonance where the system's own is on its side.
Neighbours neighbours(const System& system, const Model& model, double velocity);

/// The steady state from those of the neighbours; samples next to an event are off by the square of
/// the distance from the neighbours' events. Throws ModelError where they differ in kind.
SteadyState between(const Neighbours& neighbours, const std::array<SteadyState, 4>& states);

}  // namespace vcrit::simulation
