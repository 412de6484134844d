// A sweep as an array with named dimensions (netCDF-4): one variable an axis, one a quantity, with
// units, the scene as an attribute of the file.
#pragma once

#include <cstdint>
#include <optional>

#include "maps/map_file.hpp"
#include "maps/part.hpp"
#include "maps/shared_file.hpp"

namespace vcrit::maps {

/// netCDF lays the file out: everything but numbers is on disk before the first block and not
/// touched again until the last one, so that the file can be read whatever happens in between. The
/// numbers go to their places by themselves, from all ranks. Those that are not there yet are
/// zeros, which _FillValue declares to be missing until the end; /progress/blocks holds 1 for each
/// block that is there.
class NetcdfMap : public MapFile {
 public:
  NetcdfMap(const Sweeping& sweeping, const std::filesystem::path& file, bool resume,
            const Ranks& ranks);

  std::vector<bool> done() const override { return done_; }
  std::string prepare(const BlockAnswer&) const override { return {}; }
  void write(const BlockAnswer& answer, const std::string& prepared) override;
  void finish() override;
  void discard() override;

 private:
  void create() const;
  void check() const;
  void open();

  const Sweeping& sweeping_;
  const Ranks& ranks_;
  std::filesystem::path path_;
  std::optional<PartFile> part_;  // of the first rank
  std::optional<SharedFile> opened_;
  std::vector<std::uint64_t>
      offsets_;  // of each quantity's numbers, then of the blocks that are done
  std::vector<bool> done_;
  std::size_t waiting_ = 0;  // bytes since the system was last told to write to the disk
};

}  // namespace vcrit::maps
