// The pictures of one scene for callers that know nothing of the report: as SVG, and as what they
// show.
#pragma once

#include <optional>
#include <string>

#include "problem/problem.hpp"

namespace vcrit::validation {

/// One of report/plots.hpp.
struct ScenePicture {
  std::string of;            ///< "friction", "frequency" or "cycle"
  std::optional<double> to;  ///< of friction, m/s
  double velocity = 0;       ///< of a cycle, m/s
};

/// Throws InputError for another picture and as plots.hpp does, ModelError likewise.
std::string picture_svg(const Problem& problem, const ScenePicture& picture);

/// JSON, a list of what figure_json.hpp says.
std::string picture_json(const Problem& problem, const ScenePicture& picture);

}  // namespace vcrit::validation
