#include "maps/hdf5_map.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>

#include "base/errors.hpp"

namespace vcrit::maps {

namespace fs = std::filesystem;
using hdf5::Object;

namespace {

constexpr const char* progress_group = "progress";
constexpr const char* blocks_done = "/progress/blocks";

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
  const auto take = [&taken](const std::string& option, const std::string& name) {
    if (!taken.insert(variable_name(name)).second)
      throw InputError(
          {fmt::format("{} {}", option, name)},
          fmt::format("{}, the name of something else in the file", variable_name(name)),
          "another name of this element in the scene, or a file ending in .csv");
  };
  for (const SweptQuantity& quantity : sweep.quantities) take("--quantity", column_name(quantity));
  for (const Axis& axis : sweep.axes) take("--over", axis.name);
}

// Of the format of version 1.8: attributes of any length, and no marks of an open file, which would
// make one that a killed run left unreadable.
Object access(const Ranks* ranks) {
  Object list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "H5Pcreate");
  hdf5::succeeded(H5Pset_libver_bounds(list.id(), H5F_LIBVER_V18, H5F_LIBVER_V18),
                  "H5Pset_libver_bounds");
  // Numbers go to the file when they are written, before their block counts as done.
  hdf5::succeeded(H5Pset_sieve_buf_size(list.id(), 0), "H5Pset_sieve_buf_size");
  if (ranks != nullptr) share(*ranks, list.id());
  return list;
}

Object open_file(const fs::path& file, unsigned flags, const Ranks* ranks) {
  return {H5Fopen(file.c_str(), flags, access(ranks).id()), H5Fclose, "H5Fopen"};
}

Object new_file(const fs::path& file) {
  const Object creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "H5Pcreate");
  hdf5::succeeded(
      H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
      "H5Pset_link_creation_order");
  hdf5::succeeded(H5Pset_obj_track_times(creation.id(), false), "H5Pset_obj_track_times");
  return {H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation.id(), access(nullptr).id()), H5Fclose,
          "H5Fcreate"};
}

void put_attributes(const Object& file, const Sweep& sweep) {
  hdf5::put(file, "Conventions", "CF-1.8");
  if (!sweep.scene.title.empty()) hdf5::put(file, "title", sweep.scene.title);
  hdf5::put(file, "source", "vcrit " VCRIT_VERSION);
  hdf5::put(file, "scene_file", sweep.scene.file);
  hdf5::put(file, "scene", sweep.scene.text);
  hdf5::put(file, "sweep", signature(sweep));
  if (sweep.velocity) hdf5::put(file, "velocity", H5T_IEEE_F64LE, {&*sweep.velocity, 1});
  if (sweep.velocity_ratio)
    hdf5::put(file, "velocity_ratio", H5T_IEEE_F64LE, {&*sweep.velocity_ratio, 1});
}

Object coordinate(const Object& file, const Axis& axis) {
  const std::string name = variable_name(axis.name);
  Object array = hdf5::create_array(file, name, H5T_IEEE_F64LE, {axis.values.size()});
  hdf5::write_part(array, {0}, {axis.values.size()}, H5T_NATIVE_DOUBLE, axis.values.data());
  hdf5::make_scale(array, name);
  hdf5::put(array, "long_name", axis.name);
  hdf5::put(array, "units", si_unit(axis.dimension));
  return array;
}

// A byte that is missing only as long as the table is unfinished.
bool has_answer_always(const SweptQuantity& quantity) {
  return !words(quantity).empty() && first_flag(quantity) == 0;
}

void variable(const Object& file, const SweptQuantity& quantity, const std::vector<hsize_t>& size,
              const std::vector<Object>& coordinates) {
  const auto& meanings = words(quantity);
  const hid_t type = meanings.empty() ? H5T_IEEE_F64LE : H5T_STD_U8LE;
  const Object array = hdf5::create_array(file, variable_name(quantity), type, size);
  hdf5::put(array, "long_name", description(quantity));
  const double missing = has_answer_always(quantity) ? 255 : 0;
  hdf5::put(array, "_FillValue", type, {&missing, 1});
  for (unsigned d = 0; d < coordinates.size(); ++d) hdf5::attach_scale(array, coordinates[d], d);
  if (meanings.empty()) return hdf5::put(array, "units", unit(quantity));
  std::vector<double> flags;
  std::string text;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    flags.push_back(first_flag(quantity) + static_cast<double>(i));
    text += (i > 0 ? " " : "") + meanings[i];
  }
  hdf5::put(array, "flag_values", type, flags);
  hdf5::put(array, "flag_meanings", text);
}

void lay_out(const Object& file, const Sweeping& sweeping) {
  put_attributes(file, sweeping.sweep());
  std::vector<Object> coordinates;
  std::vector<hsize_t> size;
  for (const Axis& axis : sweeping.grid().axes()) {
    coordinates.push_back(coordinate(file, axis));
    size.push_back(axis.values.size());
  }
  for (const SweptQuantity& quantity : sweeping.sweep().quantities)
    variable(file, quantity, size, coordinates);
  const Object group = hdf5::create_group(file, progress_group);
  hdf5::create_array(file, blocks_done, H5T_STD_U8LE, {sweeping.grid().blocks()});
}

void to_disk(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// The system would let gigabytes wait and the disk rest until the end.
constexpr std::size_t bytes_that_wait = 32U << 20U;

void begin_writing_out(const fs::path& file) {
#ifdef SYNC_FILE_RANGE_WRITE
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return;
  ::sync_file_range(descriptor, 0, 0, SYNC_FILE_RANGE_WRITE);
  ::close(descriptor);
#endif
}

}  // namespace

Hdf5Map::Hdf5Map(const Sweeping& sweeping, const fs::path& file, bool resume, const Ranks& ranks)
    : sweeping_(sweeping), ranks_(ranks), file_(file), part_(part_of(file)) {
  // HDF5's own clean-up at the end of the program crashes over a file that could not be written.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  refuse_names_of_others(sweeping.sweep());
  ranks.first_alone([&] {
    refuse_links(part_);
    lock_.emplace(part_);
    if (resume && fs::exists(part_)) return check();
    if (fs::exists(part_))
      throw InputError({part_.string()}, "an unfinished sweep",
                       "--resume to go on with it, or that you remove it");
    create();
  });
  open();
}

// Several ranks close a file together: one that fails alone must not wait there for the others, who
// wait for it.
Hdf5Map::~Hdf5Map() {
  if (ranks_.size() == 1) return;
  for (hdf5::Object& variable : variables_) variable.leave();
  progress_.leave();
  opened_.leave();
}

void Hdf5Map::create() const {
  // The part gets its name when it is laid out: whatever has this name can be gone on with.
  fs::path unnamed = part_;
  unnamed += ".new";
  const auto refuse = [&](const std::string& found) {
    std::error_code ignored;
    fs::remove(unnamed, ignored);
    throw InputError({part_.string()}, found, "a place that can be written");
  };
  std::error_code error;
  fs::remove(unnamed, error);  // or what somebody has linked there would be written over
  try {
    Object file = new_file(unnamed);
    lay_out(file, sweeping_);
    // The file is closed, and its errors are told, only when nothing in it is open any more.
    file.close();
  } catch (const hdf5::Error& failure) {
    refuse(failure.what());
  }
  fs::rename(unnamed, part_, error);
  if (error) refuse(error.message());
}

void Hdf5Map::check() const try {
  const Object file = open_file(part_, H5F_ACC_RDONLY, nullptr);
  if (hdf5::text_of(file, "sweep") != signature(sweeping_.sweep()))
    throw InputError({part_.string()}, "the unfinished file of another sweep",
                     "the same scene, axes and quantities");
} catch (const hdf5::Error& error) {
  throw InputError({part_.string()}, error.what(), "the unfinished file of a sweep");
}

void Hdf5Map::open() try {
  opened_ = open_file(part_, H5F_ACC_RDWR, &ranks_);
  for (const SweptQuantity& quantity : sweeping_.sweep().quantities)
    variables_.push_back(hdf5::open_array(opened_, variable_name(quantity)));
  progress_ = hdf5::open_array(opened_, blocks_done);
  for (const unsigned char byte : hdf5::read_bytes(progress_, sweeping_.grid().blocks()))
    done_.push_back(byte != 0);
} catch (const hdf5::Error& error) {
  throw InputError({part_.string()}, error.what(), "the unfinished file of a sweep");
}

void Hdf5Map::write(const BlockAnswer& answer, const std::string&) try {
  const Block block = sweeping_.grid().block(answer.block);
  const std::vector<hsize_t> start(block.start.begin(), block.start.end());
  const std::vector<hsize_t> count(block.count.begin(), block.count.end());
  for (std::size_t q = 0; q < variables_.size(); ++q)
    hdf5::write_part(variables_[q], start, count, H5T_NATIVE_DOUBLE, answer.values[q].data());
  waiting_ += block.rows * sizeof(double) * variables_.size();
  if (waiting_ > bytes_that_wait) {
    begin_writing_out(part_);
    waiting_ = 0;
  }
  const unsigned char one = 1;
  hdf5::write_part(progress_, {answer.block}, {1}, H5T_NATIVE_UINT8, &one);
} catch (const hdf5::Error& error) {
  throw InputError({part_.string()}, error.what(), "a place that can be written",
                   "--resume goes on from here");
}

void Hdf5Map::finish() try {
  variables_.clear();
  progress_.close();
  opened_.close();
  ranks_.first_alone([this] {
    Object file = open_file(part_, H5F_ACC_RDWR, nullptr);
    for (const SweptQuantity& quantity : sweeping_.sweep().quantities)
      if (words(quantity).empty() || has_answer_always(quantity))
        hdf5::remove_attribute(hdf5::open_array(file, variable_name(quantity)), "_FillValue");
    file.close();
    to_disk(part_);
    fs::rename(part_, file_);
  });
} catch (const hdf5::Error& error) {
  throw InputError({part_.string()}, error.what(), "a place that can be written");
} catch (const fs::filesystem_error& error) {
  throw InputError({file_.string()}, error.code().message(), "a place that can be written");
}

void Hdf5Map::discard() {
  variables_.clear();
  progress_.close();
  opened_.close();
  ranks_.first_alone([this] {
    std::error_code ignored;
    fs::remove(part_, ignored);
  });
}

}  // namespace vcrit::maps
