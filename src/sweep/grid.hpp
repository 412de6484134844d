// The points of a sweep in row-major order of its axes, and the blocks of them that are found and
// written at once.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sweep/axis.hpp"

namespace vcrit {

/// A box of the grid whose rows follow each other: one index along each axis before `along`, a
/// range along that one, everything along those behind it.
struct Block {
  std::size_t first = 0, rows = 0;
  std::vector<std::size_t> start, count;  ///< of each axis
};

class Grid {
 public:
  /// Blocks of at most about `rows_at_once` rows; along an axis of speeds they hold a multiple of
  /// `speeds_at_once` of them or all. Throws InputError for two axes of the same name, two of
  /// speeds, and more rows than can be counted.
  Grid(std::vector<Axis> axes, std::size_t rows_at_once, std::size_t speeds_at_once = 1);

  const std::vector<Axis>& axes() const { return axes_; }
  /// The place of the axis of speeds, if there is one.
  std::optional<std::size_t> speed() const { return speed_; }
  std::size_t rows() const { return rows_; }
  std::size_t blocks() const { return outer_ * pieces_; }
  Block block(std::size_t index) const;

  /// How many rows lie between neighbours along an axis.
  std::size_t stride(std::size_t axis) const { return strides_[axis]; }
  double value(std::size_t axis, std::size_t row) const {
    const std::vector<double>& values = axes_[axis].values;
    return values[row / strides_[axis] % values.size()];
  }

 private:
  void divide(std::size_t rows_at_once, std::size_t speeds_at_once);

  std::vector<Axis> axes_;
  std::vector<std::size_t> strides_;
  std::optional<std::size_t> speed_;
  std::size_t rows_ = 1;
  std::size_t along_ = 0, piece_ = 1, pieces_ = 1, outer_ = 1;
};

}  // namespace vcrit
