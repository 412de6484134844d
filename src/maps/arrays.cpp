#include "maps/arrays.hpp"

#ifdef VCRIT_WITH_NETCDF
#include "maps/netcdf_map.hpp"
#endif

namespace vcrit::maps {

#ifdef VCRIT_WITH_NETCDF

OpenMap* array_opener() {
  return [](const Sweeping& sweeping, const std::filesystem::path& file, bool resume,
            const Ranks& ranks) -> std::unique_ptr<MapFile> {
    return std::make_unique<NetcdfMap>(sweeping, file, resume, ranks);
  };
}

#else

OpenMap* array_opener() { return nullptr; }

#endif

}  // namespace vcrit::maps
