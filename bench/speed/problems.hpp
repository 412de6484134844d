// The nine problems: a scene without values, the type that stands for it in the code by hand, and
// the range of each parameter.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::speed {

struct VariedParameter {
  Symbol symbol;
  double least = 0, greatest = 0;  ///< SI units
};

struct Subject {
  std::string name;                      ///< "Prony-10"
  std::string by_hand;                   ///< "Scene<Prony, Prony, Prony>", peers/networks.hpp
  std::vector<VariedParameter> columns;  ///< mu0, omega, du_z, m; of K_n, K_t, K_d
  Problem problem;
};

/// The place of omega among the columns.
inline constexpr std::size_t omega_column = 1;

std::vector<Subject> all_subjects();

}  // namespace vcrit::speed
