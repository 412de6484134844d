// Sweeps as arrays, for programs that load netCDF.
#pragma once

#include "maps/map_file.hpp"

namespace vcrit::maps {

/// Opens arrays; null in a vcrit that was built without netCDF.
OpenMap* array_opener();

}  // namespace vcrit::maps
