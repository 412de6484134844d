// A file by netCDF's C library, as far as maps need it. Every function throws netcdf::Error.
#pragma once

#include <hdf5.h>
#include <netcdf.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace vcrit::netcdf {

/// The attribute with the number that counts as missing.
inline constexpr const char* fill_value = "_FillValue";

/// The system's own words where it refused something, else those of netCDF.
class Error : public std::runtime_error {
 public:
  explicit Error(int status);
};

/// Calls a function of netCDF.
template <class... Parameters, class... Arguments>
void call(int (*function)(Parameters...), Arguments... arguments) {
  errno = 0;
  if (const int status = function(arguments...); status != NC_NOERR) throw Error(status);
}

class File {
 public:
  static File create(const std::filesystem::path& path);
  static File open(const std::filesystem::path& path, int mode);  ///< NC_NOWRITE, NC_WRITE

  int id() const { return id_; }
  /// The number of an array of this name.
  int array(const std::string& name) const;
  /// Where in the file the numbers of an array begin.
  std::uint64_t offset(const std::string& path) const;
  /// A file that is not closed may lack what was put into it.
  void close();

 private:
  File(int id, const std::filesystem::path& path, bool writable);

  int id_ = -1;
  hid_t same_ = -1;  // the same file in HDF5's hands
};

/// An attribute of an array, or of all with NC_GLOBAL.
void put(int group, int array, const std::string& name, const std::string& text);
void put(int group, int array, const std::string& name, nc_type type,
         std::span<const double> values);
/// Of the whole file.
std::string text_of(int group, const std::string& name);

/// An array in one piece, left unwritten.
int create_array(int group, const std::string& name, nc_type type,
                 const std::vector<int>& dimensions);
/// Sets its space aside, as a hole of zeros.
void set_aside(int group, int array, std::size_t dimensions);

}  // namespace vcrit::netcdf
