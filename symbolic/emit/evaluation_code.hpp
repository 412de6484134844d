// Eq. 24 as the statements of the generated evaluate<T>().
#pragma once

#include <string>
#include <vector>

#include "emit/parameters.hpp"
#include "scene/scene.hpp"

namespace vcrit::symbolic {

struct EvaluationCode {
  std::vector<std::string> lines;
  std::vector<std::string> ranges;  ///< expressions in p that must be neither huge nor tiny
  int operations = 0;
  bool has_mass = false, meshed = false, has_length = false;
};

EvaluationCode evaluation_code(const Scene& scene, const ParameterList& parameters);

}  // namespace vcrit::symbolic
