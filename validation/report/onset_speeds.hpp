// Where vibration ends to lower friction, and how pages call it.
#pragma once

#include <string>

#include "compare/scene_report.hpp"

namespace vcrit::validation::report {

/// Speeds from which on vibration lowers friction no more, m/s.
struct OnsetSpeeds {
  double contact = 0;      ///< v*
  double drive = 0;        ///< larger only where the path creeps
  bool simulated = false;  ///< as Eq. 24 is not v* there

  bool creeps() const { return drive > contact; }
  /// How the page calls the speed of the drive: "v*", or "v* + creep".
  std::string sign() const;
  /// The same beside an operator: "v*", or "(v* + creep)".
  std::string factor() const;
};
OnsetSpeeds onset_speeds(const SceneReport& report);

}  // namespace vcrit::validation::report
