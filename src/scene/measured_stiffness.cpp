#include "scene/measured_stiffness.hpp"

#include "scene/bracket.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit {

std::optional<MeasuredNumbers> numbers_at(const MeasuredStiffness& measured, double omega) {
  const auto [below, above] = rows_around(measured.table->rows, omega);
  if (below == nullptr) return std::nullopt;
  if (below == above) return MeasuredNumbers{below->storage, below->loss / below->storage};
  const double width = above->omega - below->omega, share = (omega - below->omega) / width;
  const double storage = (1 - share) * below->storage + share * above->storage;
  const double loss = (1 - share) * below->loss + share * above->loss;
  const double storage_slope = (above->storage - below->storage) / width;
  const double loss_slope = (above->loss - below->loss) / width;
  return MeasuredNumbers{
      storage, loss / storage,
      std::pair{storage_slope, (loss_slope - loss / storage * storage_slope) / storage}};
}

std::string outside_words(const MeasuredStiffness& measured, double omega) {
  const auto& rows = measured.table->rows;
  return outside_words(omega, "the measured stiffness in " + measured.table->file,
                       rows.front().omega, rows.back().omega);
}

}  // namespace vcrit
