#include "sweep/grid.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/numbers.hpp"

namespace vcrit {

bool is_speed(const Axis& axis) { return axis.name == "velocity" || axis.name == "velocity_ratio"; }

Grid::Grid(std::vector<Axis> axes) : axes_(std::move(axes)) {
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    const Place place{fmt::format("--over {}", axes_[a].name)};
    for (std::size_t b = 0; b < a; ++b)
      if (axes_[b].name == axes_[a].name)
        throw InputError(place, "the same axis again", "each quantity once");
    if (!is_speed(axes_[a])) {
      scenes_ *= axes_[a].values.size();
      continue;
    }
    if (speed_) throw InputError(place, "a second axis of speeds", "velocity or velocity_ratio");
    speed_ = a;
  }
}

std::size_t Grid::row(std::size_t scene, std::size_t speed) const {
  std::size_t row = 0, stride = 1;
  for (std::size_t a = axes_.size(); a-- > 0;) {
    const std::size_t size = axes_[a].values.size();
    std::size_t& rest = speed_ == a ? speed : scene;
    row += rest % size * stride;
    rest /= size;
    stride *= size;
  }
  return row;
}

std::vector<double> Grid::point(std::size_t row) const {
  std::vector<double> values(axes_.size());
  for (std::size_t a = axes_.size(); a-- > 0;) {
    values[a] = axes_[a].values[row % axes_[a].values.size()];
    row /= axes_[a].values.size();
  }
  return values;
}

Settings Grid::settings(std::size_t scene) const {
  const std::vector<double> values = point(row(scene, 0));
  Settings settings;
  for (std::size_t a = 0; a < axes_.size(); ++a)
    if (speed_ != a) settings.emplace_back(axes_[a].name, to_text(values[a]));
  return settings;
}

}  // namespace vcrit
