// The simulator asked just below v* and just above it, over cells of extremes.
#pragma once

#include <functional>
#include <vector>

#include "accuracy/cells.hpp"
#include "accuracy/simulated_cell.hpp"
#include "extremes/judging.hpp"

namespace vcrit::validation::extremes {

/// One question to the simulator about a scene of which v* (m/s) is known.
using Ask = std::function<accuracy::SimulatedCell(const Problem& problem, double right)>;

/// Asks about the cells in `which`. Left out is where v* is no normal double, where conditioning
/// leaves v* unknown to less than a tenth of 1e-6 in doubles, and where the stuck body swings over
/// 10,000 times in a period.
Simulated simulate(const Problem& problem, const accuracy::Cells& cells, const Known& known,
                   const std::vector<std::size_t>& which, const Ask& ask);

Comparison stick_found(const Simulated& simulated, const std::string& where);

}  // namespace vcrit::validation::extremes
