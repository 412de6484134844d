// The benchmark as text for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "run/machine.hpp"
#include "simulators/summary.hpp"

namespace vcrit::simulators {

/// "12.3 us", "4.5 ms", "6.7 s"
std::string duration(double seconds);

/// Methods and settings on one problem, by method and accuracy.
std::string work_precision_table(const std::vector<SettingLine>& lines, const std::string& problem);

/// The exact method against the goals that it was built for, and the rows that a peer did faster.
std::string summary_table(const std::vector<Case>& cases, const std::vector<PeerSolve>& points);

/// The paper's reduced model less the full motion over delta and v0/v*, at D = 0.9/sqrt(1 +
/// delta^2).
std::string reduced_model_table();

/// Machine, system, compiler and its flags, and the versions of all parts.
validation::Machine benchmark_machine();
std::string machine_lines(const validation::Machine& machine);

/// All points, as JSON.
std::string as_json(const std::vector<PeerSolve>& points, const validation::Machine& machine,
                    const Budget& budget);

}  // namespace vcrit::simulators
