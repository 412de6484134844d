#include "report/onset_speeds.hpp"

namespace vcrit::validation::report {

OnsetSpeeds onset_speeds(const SceneReport& report) {
  if (report.indented && !report.indented->closed_form)
    return {report.indented->critical_velocity, report.indented->critical_velocity, true};
  if (report.separation && !report.separation->closed_form)
    return {report.separation->critical_velocity, report.separation->drive_velocity, true};
  if (report.effect && report.effect->by_phase)
    return {report.effect->critical_velocity, report.effect->drive_velocity, false};
  return {report.critical_velocity, report.critical_velocity + report.creep_velocity, false};
}

std::string OnsetSpeeds::sign() const { return creeps() ? "v* + creep" : "v*"; }

std::string OnsetSpeeds::factor() const { return creeps() ? "(" + sign() + ")" : sign(); }

}  // namespace vcrit::validation::report
