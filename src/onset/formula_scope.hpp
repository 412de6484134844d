// Whether Eq. (24) is v*: one answer, asked by all that evaluate, print, generate or compare it.
// Where the surfaces never part it always is. Where they may, it holds on for two kinds of scenes:
//   - a path without mass, damper and branches: the contact velocity is v0 less the rate of the
//     friction bound over a stiffness, and the bound is steepest where the closed contact has it;
//   - an isotropic contact under a rigid drive: in sliding the tangential deformations are mu0
//     K_n/K_t times the normal ones, while touching and while apart, so that the contact velocity
//     is v0 - mu0 (K_n/K_t) du_z/dt whatever the network; as long as the surfaces touch where u_z
//     rises fastest, which a surface that creeps back too slowly does not.
#pragma once

#include "scene/scene.hpp"

namespace vcrit {

enum class FormulaScope {
  always,          ///< for all values
  while_touching,  ///< while the surfaces touch where the indentation rises fastest
  never,           ///< v* is another one as soon as the surfaces part
};

/// By the kind of scene alone.
FormulaScope formula_scope(const Scene& scene);

/// With the values of the scene. Throws InputError for missing values, ModelError where the motion
/// of the surfaces is outside the model.
bool formula_holds(const Scene& scene);

}  // namespace vcrit
