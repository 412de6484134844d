// The nine problems: a scene without values, the type that stands for it in the code by hand, and
// the range of each parameter.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace vcrit::speed {

struct VariedParameter {
  Symbol symbol;
  double least = 0, greatest = 0;  ///< SI units
};

struct Problem {
  std::string name;                      ///< "Prony-10"
  std::string by_hand;                   ///< "Scene<Prony, Prony, Prony>", peers/networks.hpp
  std::vector<VariedParameter> columns;  ///< mu0, omega, du_z, m; of K_n, K_t, K_d
  Scene scene;
};

/// The place of omega among the columns.
inline constexpr std::size_t omega_column = 1;

std::vector<Problem> all_problems();

}  // namespace vcrit::speed
