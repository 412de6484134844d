#include "maps/netcdf_map.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>

#include "base/errors.hpp"
#include "maps/netcdf_file.hpp"

namespace vcrit::maps {

namespace fs = std::filesystem;
using netcdf::call;

namespace {

constexpr const char* progress_group = "progress";
constexpr const char* blocks_array = "blocks";
constexpr const char* blocks_done = "/progress/blocks";
constexpr const char* blocks_dimension = "block";

/// Letters, digits and underscores alone, as the conventions CF want it: k[3] is k_3.
std::string variable_name(std::string name) {
  std::erase(name, ']');
  std::replace(name.begin(), name.end(), '[', '_');
  return name;
}

std::string variable_name(const SweptQuantity& quantity) {
  return variable_name(column_name(quantity));
}

/// An element of the scene may be named as the file's group, or k_3 beside k[3].
void refuse_names_of_others(const Sweep& sweep) {
  std::set<std::string> taken{progress_group};
  const auto take = [&taken](const std::string& what, const std::string& name) {
    if (!taken.insert(variable_name(name)).second)
      throw InputError(
          argument(what + " " + name),
          fmt::format("{}, the name of something else in the file", variable_name(name)),
          "another name of this element in the scene, or a file ending in .csv");
  };
  for (const SweptQuantity& quantity : sweep.quantities) take("quantity", column_name(quantity));
  for (const Axis& axis : sweep.axes) take("over", axis.name);
}

void put_attributes(int file, const Sweep& sweep) {
  const auto put = [file](const char* name, const auto&... value) {
    netcdf::put(file, NC_GLOBAL, name, value...);
  };
  put("Conventions", "CF-1.8");
  if (!sweep.problem->source->title.empty()) put("title", sweep.problem->source->title);
  put("source", "vcrit " VCRIT_VERSION);
  put("scene_file", sweep.problem->source->file);
  put("scene", sweep.problem->source->text);
  put("sweep", signature(sweep));
  const auto put_number = [file](const char* name, const std::optional<double>& value) {
    if (value) netcdf::put(file, NC_GLOBAL, name, NC_DOUBLE, {&*value, 1});
  };
  put_number("velocity", sweep.velocity);
  put_number("velocity_ratio", sweep.velocity_ratio);
}

int dimension(int group, const std::string& name, std::size_t size) {
  int id = -1;
  call(nc_def_dim, group, name.c_str(), size, &id);
  return id;
}

void coordinate(int file, const Axis& axis, int dimension) {
  int array = -1;
  call(nc_def_var, file, variable_name(axis.name).c_str(), NC_DOUBLE, 1, &dimension, &array);
  netcdf::put(file, array, "long_name", axis.name);
  netcdf::put(file, array, "units", si_unit(axis.dimension));
  call(nc_put_var_double, file, array, axis.values.data());
}

bool is_number(const SweptQuantity& quantity) { return words(quantity).empty(); }

// A byte that is missing only as long as the table is unfinished.
bool has_answer_always(const SweptQuantity& quantity) {
  return !is_number(quantity) && first_flag(quantity) == 0;
}

void put_meanings(int file, int array, const SweptQuantity& quantity) {
  std::vector<double> flags;
  std::string text;
  for (const std::string& meaning : words(quantity)) {
    text += (flags.empty() ? "" : " ") + meaning;
    flags.push_back(first_flag(quantity) + static_cast<double>(flags.size()));
  }
  netcdf::put(file, array, "flag_values", NC_UBYTE, flags);
  netcdf::put(file, array, "flag_meanings", text);
}

void variable(int file, const SweptQuantity& quantity, const std::vector<int>& dimensions) {
  const nc_type type = is_number(quantity) ? NC_DOUBLE : NC_UBYTE;
  const int array = netcdf::create_array(file, variable_name(quantity), type, dimensions);
  netcdf::put(file, array, "long_name", description(quantity));
  const double missing = has_answer_always(quantity) ? 255 : 0;
  netcdf::put(file, array, netcdf::fill_value, type, {&missing, 1});
  if (is_number(quantity))
    netcdf::put(file, array, "units", unit(quantity));
  else
    put_meanings(file, array, quantity);
  netcdf::set_aside(file, array, dimensions.size());
}

void lay_out(int file, const Sweeping& sweeping) {
  put_attributes(file, sweeping.sweep());
  std::vector<int> dimensions;
  for (const Axis& axis : sweeping.grid().axes())
    dimensions.push_back(dimension(file, variable_name(axis.name), axis.values.size()));
  for (std::size_t a = 0; a < dimensions.size(); ++a)
    coordinate(file, sweeping.grid().axes()[a], dimensions[a]);
  for (const SweptQuantity& quantity : sweeping.sweep().quantities)
    variable(file, quantity, dimensions);
  int group = -1;
  call(nc_def_grp, file, progress_group, &group);
  const int blocks = dimension(group, blocks_dimension, sweeping.grid().blocks());
  netcdf::set_aside(group, netcdf::create_array(group, blocks_array, NC_UBYTE, {blocks}), 1);
}

void to_disk(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// The system would let gigabytes wait and the disk rest until the end.
constexpr std::size_t bytes_that_wait = 32U << 20U;

}  // namespace

NetcdfMap::NetcdfMap(const Sweeping& sweeping, const fs::path& file, bool resume,
                     const Ranks& ranks)
    : sweeping_(sweeping), ranks_(ranks), path_(part_of(file)) {
  // HDF5's own clean-up at the end of the program crashes over a file that could not be written.
  H5dont_atexit();
  refuse_names_of_others(sweeping.sweep());
  ranks.first_alone([&] {
    part_.emplace(file, resume);
    part_->is_there() ? check() : create();
  });
  open();
}

void NetcdfMap::create() const {
  // The part gets its name when it is laid out: whatever has this name can be gone on with.
  fs::path unnamed = path_;
  unnamed += ".new";
  std::error_code error;
  fs::remove(unnamed, error);  // or what somebody has linked there would be written over
  try {
    netcdf::File file = netcdf::File::create(unnamed);
    lay_out(file.id(), sweeping_);
    file.close();
    fs::rename(unnamed, path_);
  } catch (const std::runtime_error& failure) {
    fs::remove(unnamed, error);
    const auto* of_system = dynamic_cast<const fs::filesystem_error*>(&failure);
    refuse_part(path_, of_system == nullptr ? failure.what() : of_system->code().message());
  }
}

void NetcdfMap::check() const try {
  netcdf::File file = netcdf::File::open(path_, NC_NOWRITE);
  const std::string found = netcdf::text_of(file.id(), "sweep");
  file.close();
  if (found != signature(sweeping_.sweep()))
    throw InputError({path_.string()}, "the unfinished file of another sweep",
                     "the same scene, axes and quantities");
} catch (const netcdf::Error& error) {
  throw InputError({path_.string()}, error.what(), "the unfinished file of a sweep");
}

void NetcdfMap::open() try {
  netcdf::File file = netcdf::File::open(path_, NC_NOWRITE);
  for (const SweptQuantity& quantity : sweeping_.sweep().quantities)
    offsets_.push_back(file.offset("/" + variable_name(quantity)));
  offsets_.push_back(file.offset(blocks_done));
  file.close();
  opened_.emplace(path_, ranks_);
  std::vector<unsigned char> blocks(sweeping_.grid().blocks());
  opened_->read(offsets_.back(), blocks.data(), blocks.size());
  for (const unsigned char byte : blocks) done_.push_back(byte != 0);
} catch (const InputError&) {
  throw;
} catch (const std::runtime_error& error) {
  throw InputError({path_.string()}, error.what(), "the unfinished file of a sweep");
}

void NetcdfMap::write(const BlockAnswer& answer, const std::string&) try {
  const Block block = sweeping_.grid().block(answer.block);
  const auto& quantities = sweeping_.sweep().quantities;
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const std::vector<double>& values = answer.values[q];
    if (is_number(quantities[q])) {
      opened_->write(offsets_[q] + block.first * sizeof(double), values.data(),
                     block.rows * sizeof(double));
      continue;
    }
    std::vector<unsigned char> bytes;
    for (const double value : values) bytes.push_back(static_cast<unsigned char>(value));
    opened_->write(offsets_[q] + block.first, bytes.data(), block.rows);
  }
  waiting_ += block.rows * sizeof(double) * quantities.size();
  if (waiting_ > bytes_that_wait) {
    opened_->begin_writing_out();
    waiting_ = 0;
  }
  const unsigned char one = 1;
  opened_->write(offsets_.back() + answer.block, &one, 1);
} catch (const std::runtime_error& error) {
  refuse_part(path_, error.what(), goes_on);
}

void NetcdfMap::finish() try {
  opened_->close();
  ranks_.first_alone([this] {
    netcdf::File file = netcdf::File::open(path_, NC_WRITE);
    for (const SweptQuantity& quantity : sweeping_.sweep().quantities)
      if (is_number(quantity) || has_answer_always(quantity)) {
        const int array = file.array(variable_name(quantity));
        // It is gone already where an earlier run ended between this step and the next one.
        if (nc_inq_att(file.id(), array, netcdf::fill_value, nullptr, nullptr) == NC_NOERR)
          call(nc_del_att, file.id(), array, netcdf::fill_value);
      }
    file.close();
    to_disk(path_);
    part_->put_into_place();
  });
} catch (const InputError&) {
  throw;
} catch (const std::runtime_error& error) {
  refuse_part(path_, error.what());
}

void NetcdfMap::discard() {
  opened_->close();
  ranks_.first_alone([this] { part_->remove(); });
}

}  // namespace vcrit::maps
