#include "scene/measured_table.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "base/rounded.hpp"
#include "scene/stiffness_columns.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit {

namespace {

void refuse_active(const StiffnessRow& row, const std::string& file) {
  const Place place{file, row.line};
  if (!(row.storage > 0))
    throw InputError(place, "a storage stiffness of " + rounded(row.storage, "N/m"),
                     "one above 0 in each row", "leave out the row, or fit a network: vcrit fit");
  if (row.loss < 0)
    throw InputError(place, "a loss stiffness of " + rounded(row.loss, "N/m"),
                     "at least 0 in each row: a contact below that gives energy",
                     "leave out the row, or fit a network: vcrit fit");
}

}  // namespace

std::shared_ptr<const StiffnessTable> read_measured_stiffness(const std::string& file,
                                                              const Place& place,
                                                              std::vector<Warning>& notes) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(place, fmt::format("dynamic stiffness = \"{}\", which is no file", file),
                     "a table in CSV with " + expected_columns());
  auto data = std::make_shared<StiffnessTable>(read_stiffness_table(file));
  for (const StiffnessRow& row : data->rows) refuse_active(row, file);
  for (const std::string& note : data->notes) notes.push_back({{file}, note});
  return data;
}

}  // namespace vcrit
