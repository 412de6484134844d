// Quantities of a scene over a grid: any of its parameters and the speed, on all cores.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sweep/axis.hpp"

namespace vcrit {

enum class SweptQuantity { critical_velocity, friction_ratio, friction_ratio_error };

/// "critical_velocity", "friction_ratio", "friction_ratio_error".
const char* to_text(SweptQuantity quantity);

struct Sweep {
  Scene scene;  ///< its text is read again at each point, with the settings and the axes' values
  Settings settings;  ///< those of --set
  std::vector<Axis> axes;
  std::vector<SweptQuantity> quantities;
  std::optional<double> velocity;        ///< of the drive, m/s, for friction without such an axis
  std::optional<double> velocity_ratio;  ///< the same in units of v*
};

struct SweptTable {
  std::vector<std::string> columns;  ///< axes, then quantities
  std::vector<double> values;        ///< row by row; NaN where a point is outside the model
  std::size_t rows = 0;
  std::size_t outside = 0;  ///< rows outside the model
  std::string reason;       ///< of the first of them
};

/// Rows in row-major order of the axes. Does not depend on the number of threads.
/// Throws InputError for wrong axes and values.
SweptTable swept(const Sweep& sweep);

/// A header row, then one row a point; numbers read back to the same doubles.
std::string to_csv(const SweptTable& table);

}  // namespace vcrit
