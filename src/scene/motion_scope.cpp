#include "scene/motion_scope.hpp"

#include "network/masses.hpp"

namespace vcrit {

std::string beyond_simulation(const Scene& scene) {
  if (scene.receptance)
    return "the simulator needs a network; this drive is a measured receptance, which says nothing "
           "of motion that is not harmonic";
  if (scene.drive && has_masses(*scene.drive))
    return "the simulator knows one body; this drive holds masses of its own";
  if (!knows_all_frequencies(scene))
    return "lossy(k, eta) is not causal: K = k (1 + i eta) at one frequency is no law of motion";
  return {};
}

}  // namespace vcrit
