#include "maps/map_file.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <cstring>

#include "base/commit.hpp"
#include "base/numbers.hpp"
#include "maps/csv_map.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit::maps {

namespace {

// FNV-1a over the bits of the numbers.
std::uint64_t fingerprint(const std::vector<double>& values) {
  std::uint64_t hash = 14695981039346656037U;
  for (const double value : values) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; ++byte)
      hash = (hash ^ (bits >> (8 * byte) & 255U)) * 1099511628211U;
  }
  return hash;
}

}  // namespace

std::string signature(const Sweep& sweep) {
  std::string text = fmt::format("vcrit {} (commit {})\n", VCRIT_VERSION, commit());
  for (const auto& [name, value] : sweep.problem->source->settings)
    text += fmt::format("set {}={}\n", name, value);
  for (const Axis& axis : sweep.axes)
    text += fmt::format("over {}: {} values from {} to {}, fingerprint {:016x}\n", axis.name,
                        axis.values.size(), to_text(axis.values.front()),
                        to_text(axis.values.back()), fingerprint(axis.values));
  for (const SweptQuantity& quantity : sweep.quantities)
    text += fmt::format("quantity {}\n", column_name(quantity));
  if (sweep.velocity) text += fmt::format("velocity {}\n", to_text(*sweep.velocity));
  if (sweep.velocity_ratio)
    text += fmt::format("velocity_ratio {}\n", to_text(*sweep.velocity_ratio));
  if (const Receptance* measured = sweep.problem->receptance()) {
    std::vector<double> numbers;
    for (const Receptance::Row& row : measured->rows)
      numbers.insert(numbers.end(), {row.omega, row.re, row.im});
    text += fmt::format("receptance, fingerprint {:016x}\n", fingerprint(numbers));
  }
  for (const MeasuredStiffness& measured : sweep.problem->measured) {
    std::vector<double> numbers;
    for (const StiffnessRow& row : measured.table->rows)
      numbers.insert(numbers.end(), {row.omega, row.storage, row.loss});
    text += fmt::format("dynamic stiffness, fingerprint {:016x}\n", fingerprint(numbers));
  }
  if (sweep.problem->indenter && sweep.problem->indenter->profile) {
    std::vector<double> numbers;
    for (const Profile::Row& row : sweep.problem->indenter->profile->rows)
      numbers.insert(numbers.end(), {row.r, row.f});
    text += fmt::format("indenter, fingerprint {:016x}\n", fingerprint(numbers));
  }
  return text + sweep.problem->source->text;
}

bool is_array(const std::filesystem::path& file) {
  const std::string ending = file.extension();
  return ending == ".h5" || ending == ".hdf5" || ending == ".nc";
}

std::unique_ptr<MapFile> open_map(const Sweeping& sweeping, const std::filesystem::path& file,
                                  bool resume, const Ranks& ranks, OpenMap* open_array) {
  if (file.extension() == ".csv") return std::make_unique<CsvMap>(sweeping, file, resume, ranks);
  if (!is_array(file))
    throw InputError(argument("out"), fmt::format("\"{}\"", file.string()),
                     "a file ending in .csv, .h5, .hdf5 or .nc");
  if (open_array == nullptr)
    throw InputError(argument("out"),
                     fmt::format("\"{}\" and a vcrit built without netCDF", file.string()),
                     "a file ending in .csv", "or install libnetcdf-dev and build vcrit again");
  return open_array(sweeping, file, resume, ranks);
}

}  // namespace vcrit::maps
