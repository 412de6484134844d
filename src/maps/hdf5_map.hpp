// A sweep as an array with named dimensions (HDF5 by the conventions of netCDF-4): one variable an
// axis, one a quantity, with units, the scene as an attribute of the file.
#pragma once

#include <cstdint>
#include <optional>

#include "maps/hdf5_objects.hpp"
#include "maps/map_file.hpp"
#include "maps/part_lock.hpp"

namespace vcrit::maps {

/// Everything but numbers is on disk before the first block and not touched again until the last
/// one, so that the file can be read whatever happens in between. Numbers that are not there yet
/// are zeros, which _FillValue declares to be missing until the end; /progress/blocks holds 1 for
/// each block that is there.
class Hdf5Map : public MapFile {
 public:
  Hdf5Map(const Sweeping& sweeping, const std::filesystem::path& file, bool resume,
          const Ranks& ranks);
  Hdf5Map(const Hdf5Map&) = delete;
  Hdf5Map& operator=(const Hdf5Map&) = delete;
  ~Hdf5Map() override;

  std::vector<bool> done() const override { return done_; }
  std::string prepare(const BlockAnswer&) const override { return {}; }
  void write(const BlockAnswer& answer, const std::string& prepared) override;
  void finish() override;
  void discard() override;

 private:
  void create() const;
  void check() const;
  void open();

  std::optional<PartLock> lock_;  // of the first rank; released last
  const Sweeping& sweeping_;
  const Ranks& ranks_;
  std::filesystem::path file_, part_;
  hdf5::Object opened_, progress_;
  std::vector<hdf5::Object> variables_;
  std::vector<bool> done_;
  std::size_t waiting_ = 0;  // bytes since the system was last told to write to the disk
};

}  // namespace vcrit::maps
