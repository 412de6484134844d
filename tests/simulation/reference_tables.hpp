// Networks as the tables of tests/data have them.
#pragma once

#include <sstream>
#include <string>

#include "stiffness/relaxation.hpp"

namespace vcrit::reference {

/// "k_inf c k:tau k:tau ..."
inline Relaxation network(const std::string& text) {
  std::istringstream in(text);
  Relaxation form;
  in >> form.equilibrium >> form.damper;
  for (std::string branch; in >> branch;) {
    const auto colon = branch.find(':');
    form.branches.push_back(
        {std::stod(branch.substr(0, colon)), std::stod(branch.substr(colon + 1))});
  }
  return form;
}

}  // namespace vcrit::reference
