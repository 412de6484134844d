// Quantities of a scene over a grid of its parameters and the speed, block by block.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "answers/closed_share.hpp"
#include "answers/critical_onsets.hpp"
#include "problem/problem.hpp"
#include "sweep/axis.hpp"
#include "sweep/grid.hpp"
#include "sweep/quantity.hpp"

namespace vcrit {

struct Sweep {
  Problem problem;
  std::vector<Axis> axes;
  std::vector<SweptQuantity> quantities;
  std::optional<double> velocity;        ///< of the drive, m/s, for motion without such an axis
  std::optional<double> velocity_ratio;  ///< the same in units of v*
  bool units_in_header = false;          ///< of a table in a file: "frequency [Hz]"
};

/// The quantities in one block, row by row.
struct BlockAnswer {
  std::size_t block = 0;
  std::vector<std::vector<double>> values;  ///< of each quantity; NaN (words: 0) outside the model
  std::size_t outside = 0;                  ///< rows outside the model
  std::string reason;                       ///< of the first of them
};

class Sweeping {
 public:
  /// Throws InputError for wrong axes and values.
  explicit Sweeping(const Sweep& sweep);

  const Sweep& sweep() const { return sweep_; }
  const Grid& grid() const { return grid_; }
  /// Depends on nothing but the sweep; may be called from several threads at once.
  BlockAnswer answer(std::size_t block) const;

 private:
  class Rows;

  /// A length of the scene that may be an axis.
  class Varying {
   public:
    Varying(const Problem& problem, const Grid& grid, const std::vector<std::size_t>& parameters,
            const Quantity& quantity);
    double of(const Grid& grid, std::size_t row) const;

   private:
    double value_;
    std::optional<std::size_t> axis_;
  };

  Sweep sweep_;
  Grid grid_;
  std::vector<std::size_t> parameters_;  // the axes that are not of speeds
  CriticalOnsets critical_;
  Varying amplitude_, pressing_;
  std::optional<ClosedShare> closed_;  // unless elements of the normal network vanish on the way
};

/// A column of its table: an axis or a quantity.
struct SweptColumn {
  std::string name, unit;  ///< SI; "" or "1" where there is none
};
std::vector<SweptColumn> swept_columns(const Sweep& sweep);

/// "frequency [Hz]", or the name alone where there is no unit.
std::string column_heading(const std::string& name, const std::string& unit);

struct SweptTable {
  std::vector<std::string> columns;  ///< axes, then quantities
  std::vector<double> values;        ///< row by row; NaN (words: 0) outside the model
  std::size_t rows = 0;
  std::size_t outside = 0;  ///< rows outside the model
  std::string reason;       ///< of the first of them
};

/// The whole sweep in memory, rows in row-major order of the axes, on all cores.
SweptTable swept(const Sweep& sweep);

}  // namespace vcrit
