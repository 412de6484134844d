#include "maps/netcdf_file.hpp"

#include <cstring>

namespace vcrit::netcdf {

namespace {

// Where the system refused something, netCDF says no more than that HDF5 failed, or hands its
// number on.
const char* words_of(int status) {
  const bool of_the_system = status > 0 || status == NC_EHDFERR;
  return of_the_system && errno != 0 ? std::strerror(errno) : nc_strerror(status);
}

void succeeded(herr_t status) {
  if (status < 0) throw Error(NC_EHDFERR);
}

}  // namespace

Error::Error(int status) : std::runtime_error(words_of(status)) {}

File File::create(const std::filesystem::path& path) {
  int id = -1;
  call(nc_create, path.c_str(), NC_NETCDF4 | NC_CLOBBER, &id);
  return {id, path, true};
}

File File::open(const std::filesystem::path& path, int mode) {
  int id = -1;
  call(nc_open, path.c_str(), mode, &id);
  return {id, path, (mode & NC_WRITE) != 0};
}

File::File(int id, const std::filesystem::path& path, bool writable)
    : id_(id), same_(H5Fopen(path.c_str(), writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY, H5P_DEFAULT)) {
  if (same_ < 0) throw Error(NC_EHDFERR);
}

int File::array(const std::string& name) const {
  int array = -1;
  call(nc_inq_varid, id_, name.c_str(), &array);
  return array;
}

std::uint64_t File::offset(const std::string& path) const {
  const hid_t array = H5Dopen2(same_, path.c_str(), H5P_DEFAULT);
  const haddr_t offset = array < 0 ? HADDR_UNDEF : H5Dget_offset(array);
  if (array >= 0) H5Dclose(array);
  if (offset == HADDR_UNDEF) throw Error(NC_EHDFERR);
  return offset;
}

// netCDF crashes where closing a file fails that nobody else has open: the last writing is done by
// HDF5's own call.
void File::close() {
  errno = 0;
  succeeded(H5Fflush(same_, H5F_SCOPE_GLOBAL));
  call(nc_close, id_);
  errno = 0;
  succeeded(H5Fclose(same_));
}

void put(int group, int array, const std::string& name, const std::string& text) {
  call(nc_put_att_text, group, array, name.c_str(), text.size(), text.data());
}

void put(int group, int array, const std::string& name, nc_type type,
         std::span<const double> values) {
  call(nc_put_att_double, group, array, name.c_str(), type, values.size(), values.data());
}

std::string text_of(int group, const std::string& name) {
  std::size_t length = 0;
  call(nc_inq_attlen, group, NC_GLOBAL, name.c_str(), &length);
  std::string text(length, '\0');
  call(nc_get_att_text, group, NC_GLOBAL, name.c_str(), text.data());
  return text;
}

int create_array(int group, const std::string& name, nc_type type,
                 const std::vector<int>& dimensions) {
  int array = -1;
  const int count = static_cast<int>(dimensions.size());
  call(nc_def_var, group, name.c_str(), type, count, dimensions.data(), &array);
  call(nc_def_var_chunking, group, array, NC_CONTIGUOUS, nullptr);
  call(nc_def_var_fill, group, array, NC_NOFILL, nullptr);
  return array;
}

void set_aside(int group, int array, std::size_t dimensions) {
  const std::vector<std::size_t> first(dimensions, 0);
  const double zero = 0;
  call(nc_put_var1_double, group, array, first.data(), &zero);
}

}  // namespace vcrit::netcdf
