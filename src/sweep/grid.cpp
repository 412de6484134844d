#include "sweep/grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace vcrit {

namespace {

bool is_speed(const Axis& axis) { return axis.name == "velocity" || axis.name == "velocity_ratio"; }

std::size_t quotient_rounded_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

Grid::Grid(std::vector<Axis> axes, std::size_t rows_at_once, std::size_t speeds_at_once)
    : axes_(std::move(axes)), strides_(axes_.size()) {
  for (std::size_t a = axes_.size(); a-- > 0;) {
    const Place place = argument("over " + axes_[a].name);
    if (axes_[a].values.empty())
      throw InputError(place, "an axis without values", "one value or more");
    for (std::size_t b = 0; b < a; ++b)
      if (axes_[b].name == axes_[a].name)
        throw InputError(place, "the same axis again", "each quantity once");
    if (is_speed(axes_[a])) {
      if (speed_) throw InputError(place, "a second axis of speeds", "velocity or velocity_ratio");
      speed_ = a;
    }
    strides_[a] = rows_;
    if (axes_[a].values.size() > std::numeric_limits<std::int64_t>::max() / rows_)
      throw InputError(argument("over"), "more than 2^63 points", "fewer");
    rows_ *= axes_[a].values.size();
  }
  divide(rows_at_once, speeds_at_once);
}

void Grid::divide(std::size_t rows_at_once, std::size_t speeds_at_once) {
  if (axes_.empty()) return;
  along_ = axes_.size() - 1;
  while (along_ > 0 && rows_at_once / strides_[along_] >= axes_[along_].values.size()) --along_;
  const std::size_t size = axes_[along_].values.size();
  const std::size_t most = std::max<std::size_t>(1, rows_at_once / strides_[along_]);
  piece_ = quotient_rounded_up(size, quotient_rounded_up(size, most));
  if (speed_ == along_)
    piece_ = std::min(size, quotient_rounded_up(piece_, speeds_at_once) * speeds_at_once);
  pieces_ = quotient_rounded_up(size, piece_);
  outer_ = rows_ / (size * strides_[along_]);
}

Block Grid::block(std::size_t index) const {
  Block block;
  block.start.assign(axes_.size(), 0);
  for (const Axis& axis : axes_) block.count.push_back(axis.values.size());
  block.rows = 1;
  if (axes_.empty()) return block;
  const std::size_t begin = index % pieces_ * piece_;
  block.start[along_] = begin;
  block.count[along_] = std::min(piece_, axes_[along_].values.size() - begin);
  block.rows = block.count[along_] * strides_[along_];
  std::size_t rest = index / pieces_;
  block.first = begin * strides_[along_];
  for (std::size_t a = along_; a-- > 0;) {
    const std::size_t size = axes_[a].values.size();
    block.start[a] = rest % size;
    block.count[a] = 1;
    block.first += rest % size * strides_[a];
    rest /= size;
  }
  return block;
}

}  // namespace vcrit
