// Names for the steps of a formula, as people would call them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "shortest/expressions.hpp"
#include "shortest/steps.hpp"

namespace vcrit::symbolic::shortest {

/// Powers of stiffness and time.
struct Measure {
  double stiffness = 0, time = 0;
};

/// What symbols measure, by node.
struct Measures {
  std::map<ExNode, Measure> symbols = {};
  std::set<ExNode> odd = {};   ///< symbols that are odd in omega
  bool dimensionless = false;  ///< nothing measures anything: letters are greek
  std::string mark = {};       ///< behind each letter, of a formula beside another one
};

/// A name for each of `named`, steps of `steps` in the order of their definitions: the letter of a
/// symbol that has one; S a sum and G a product of stiffness, Q its square, J a compliance, R a
/// number; with an index where there are several. In dimensionless groups sigma a sum, rho another
/// number, theta, zeta, ... for T, Z, ...
std::vector<std::string> letters(const Expressions& all, const Measures& measures,
                                 const Steps& steps, const std::vector<std::uint32_t>& named);

}  // namespace vcrit::symbolic::shortest
