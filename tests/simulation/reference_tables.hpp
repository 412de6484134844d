// The tables of tests/data whose networks stand as text.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/csv.hpp"
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

/// The cells of each line but the first.
inline std::vector<std::vector<std::string>> rows_of(const std::string& name) {
  const std::string path = VCRIT_TEST_DATA "/" + name;
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  CsvLines lines(text.str(), path);
  std::vector<std::vector<std::string>> rows;
  for (lines.next(); lines.next();) rows.push_back(lines.cells());
  return rows;
}

}  // namespace vcrit::reference
