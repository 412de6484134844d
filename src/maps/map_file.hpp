// The file that a sweep is streamed to: written beside its place as OUT.part, in blocks, and
// renamed when it is whole. What a killed run leaves can be read, and gone on with.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "maps/ranks.hpp"
#include "sweep/sweep.hpp"

namespace vcrit::maps {

class MapFile {
 public:
  MapFile() = default;
  MapFile(const MapFile&) = delete;
  MapFile& operator=(const MapFile&) = delete;
  virtual ~MapFile() = default;

  /// Which blocks are in the file.
  virtual std::vector<bool> done() const = 0;
  /// Whatever of the writing can be done by several threads at once; `write` gets the result.
  virtual std::string prepare(const BlockAnswer& answer) const = 0;
  /// Throws InputError naming the file when it cannot be written.
  virtual void write(const BlockAnswer& answer, const std::string& prepared) = 0;
  /// Ends the file and puts it into its place; called by all ranks when all blocks are written.
  virtual void finish() = 0;
  /// Removes the unfinished file.
  virtual void discard() = 0;
};

/// With `resume`, an unfinished file is gone on with; without it, one that is there is an
/// InputError.
using OpenMap = std::unique_ptr<MapFile>(const Sweeping& sweeping,
                                         const std::filesystem::path& file, bool resume,
                                         const Ranks& ranks);

/// Whether the file is to be an array with named dimensions, by its ending: .h5, .hdf5 or .nc.
bool is_array(const std::filesystem::path& file);

/// A table, .csv, or what `open_array` opens: null where nothing here writes arrays.
std::unique_ptr<MapFile> open_map(const Sweeping& sweeping, const std::filesystem::path& file,
                                  bool resume, const Ranks& ranks, OpenMap* open_array);

/// All that the values depend on, as text: an unfinished file is gone on with by the same sweep
/// alone.
std::string signature(const Sweep& sweep);

}  // namespace vcrit::maps
