// A sweep on all cores, streamed to its file: blocks are answered by threads and written as they
// come, so that no more than a few of them are in memory at any time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "maps/map_file.hpp"

namespace vcrit::maps {

struct StreamProgress {
  std::size_t rows = 0;         ///< of the whole sweep
  std::size_t done = 0;         ///< in the file
  std::size_t in_this_run = 0;  ///< of them, found since the start
};

struct StreamOptions {
  bool resume = false;
  int threads = 0;                ///< 0: as many as there are cores for this process
  OpenMap* open_array = nullptr;  ///< array_opener(), where this program has netCDF (arrays.hpp)
  std::function<void(const StreamProgress&)> told{};  ///< after each block, on the first rank
};

struct Streamed {
  std::size_t rows = 0;
  std::size_t found = 0;    ///< rows that this run and its ranks found; the others were there
  std::size_t outside = 0;  ///< of them, outside the model
  std::string reason;       ///< of one of them
};

/// Throws InputError, and ModelError where no row is inside the model (then there is no file).
Streamed stream(const Sweeping& sweeping, const std::filesystem::path& file,
                const StreamOptions& options, Ranks& ranks);

}  // namespace vcrit::maps
