// A contact that was measured: its dynamic stiffness at some angular frequencies, as a table of
// which the scene knows two numbers at the frequency of its oscillation.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "network/network.hpp"

namespace vcrit {

struct StiffnessTable;

/// K = K' + i K'' of the table as an element of kind `measured`, whose numbers follow omega.
struct MeasuredStiffness {
  Symbol storage, loss_factor;                  ///< K' (N/m) and K''/K'
  Symbol rest;                                  ///< K(0), of the normal contact alone
  std::shared_ptr<const StiffnessTable> table;  ///< K' above 0, K'' at least 0, omega increasing
};

/// Both numbers at one omega.
struct MeasuredNumbers {
  double storage = 0, loss_factor = 0;
  /// d/d omega of each; nothing at a row, where they have a slope on each side.
  std::optional<std::pair<double, double>> slopes = {};
};

/// Between two rows storage and loss stiffness are linear in omega (rad/s), as the receptance of a
/// drive is. Nothing outside the table.
std::optional<MeasuredNumbers> numbers_at(const MeasuredStiffness& measured, double omega);

/// "omega = 5 rad/s is outside the measured stiffness in pad.csv, 6.3 to 6e+05 rad/s".
std::string outside_words(const MeasuredStiffness& measured, double omega);

}  // namespace vcrit
