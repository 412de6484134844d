// The points of a sweep's axes: which scene and which speed each row of the table has.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sweep/axis.hpp"

namespace vcrit {

/// Rows in row-major order of the axes as given. Rows that differ in the speed alone share a scene.
class Grid {
 public:
  /// Throws InputError for two axes of the same name or two speeds.
  explicit Grid(std::vector<Axis> axes);

  const std::vector<Axis>& axes() const { return axes_; }
  const Axis* speed() const { return speed_ ? &axes_[*speed_] : nullptr; }
  std::size_t rows() const { return scenes_ * speeds(); }
  std::size_t scenes() const { return scenes_; }
  std::size_t speeds() const { return speed_ ? axes_[*speed_].values.size() : 1; }
  std::size_t row(std::size_t scene, std::size_t speed) const;
  /// The axes' values of one row.
  std::vector<double> point(std::size_t row) const;
  /// What a scene is read with.
  Settings settings(std::size_t scene) const;

 private:
  std::vector<Axis> axes_;
  std::optional<std::size_t> speed_;
  std::size_t scenes_ = 1;
};

bool is_speed(const Axis& axis);

}  // namespace vcrit
