// A stiffness typed in as a rational function of s: stiffness = "(12e6*s + 8e9)/(s + 1e3)", or,
// with names of [elements], "k0 + k1*tau*s/(1 + tau*s)".
#pragma once

#include <set>
#include <string>

#include "base/errors.hpp"
#include "network/foster.hpp"
#include "scene/stiffness_algebras.hpp"

namespace vcrit {

struct TypedStiffness {
  FosterForm form;
  std::set<std::string> keys;  ///< of [elements], that it names or that they lead to
};

/// The springs and dampers that have the stiffness `text` of [networks.NAME]; `place` is where its
/// first character stands. In N/m, or Pa of a half-space, and rad/s. Throws InputError with the
/// column, also for what no springs and dampers have.
TypedStiffness read_stiffness(const std::string& text, const std::string& name, const Place& place,
                              const StiffnessNames& names);

}  // namespace vcrit
