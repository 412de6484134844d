#include "maps/hdf5_objects.hpp"

#include <hdf5_hl.h>

#include <algorithm>

namespace vcrit::hdf5 {

namespace {

// Called from the outermost function to the innermost one; the last text stays.
herr_t take_innermost(unsigned, const H5E_error2_t* error, void* text) {
  if (error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

// The system's own words are among much else: "..., error message = 'No space left on device',
// ...".
std::string message(const char* function) {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, take_innermost, &text);
  const std::string mark = "error message = '";
  if (const auto begin = text.find(mark); begin != text.npos) {
    text.erase(0, begin + mark.size());
    text.erase(std::min(text.find('\''), text.size()));
  }
  return text.empty() ? std::string("HDF5 failed in ") + function : text;
}

Object space(const std::vector<hsize_t>& size) {
  return {size.empty() ? H5Screate(H5S_SCALAR)
                       : H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
          H5Sclose, "H5Screate"};
}

Object text_type(std::size_t length) {
  Object type(H5Tcopy(H5T_C_S1), H5Tclose, "H5Tcopy");
  succeeded(H5Tset_size(type.id(), length + 1), "H5Tset_size");
  succeeded(H5Tset_cset(type.id(), H5T_CSET_UTF8), "H5Tset_cset");
  return type;
}

}  // namespace

Error::Error(const char* function) : std::runtime_error(message(function)) {}

Object create_array(const Object& parent, const std::string& name, hid_t type,
                    const std::vector<hsize_t>& size) {
  const Object list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "H5Pcreate");
  succeeded(H5Pset_alloc_time(list.id(), H5D_ALLOC_TIME_EARLY), "H5Pset_alloc_time");
  succeeded(H5Pset_fill_time(list.id(), H5D_FILL_TIME_NEVER), "H5Pset_fill_time");
  succeeded(H5Pset_obj_track_times(list.id(), false), "H5Pset_obj_track_times");
  succeeded(H5Pset_attr_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
            "H5Pset_attr_creation_order");
  return {H5Dcreate2(parent.id(), name.c_str(), type, space(size).id(), H5P_DEFAULT, list.id(),
                     H5P_DEFAULT),
          H5Dclose, "H5Dcreate"};
}

Object create_group(const Object& parent, const std::string& name) {
  const Object list(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "H5Pcreate");
  succeeded(H5Pset_obj_track_times(list.id(), false), "H5Pset_obj_track_times");
  succeeded(H5Pset_link_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
            "H5Pset_link_creation_order");
  return {H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, list.id(), H5P_DEFAULT), H5Gclose,
          "H5Gcreate"};
}

Object open_array(const Object& parent, const std::string& name) {
  return {H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "H5Dopen"};
}

void put(const Object& object, const std::string& name, const std::string& text) {
  const Object type = text_type(text.size());
  const Object attribute(
      H5Acreate2(object.id(), name.c_str(), type.id(), space({}).id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "H5Acreate");
  succeeded(H5Awrite(attribute.id(), type.id(), text.c_str()), "H5Awrite");
}

void put(const Object& object, const std::string& name, hid_t type,
         std::span<const double> values) {
  const std::vector<hsize_t> size{values.size()};
  const Object attribute(
      H5Acreate2(object.id(), name.c_str(), type, space(size).id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "H5Acreate");
  succeeded(H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, values.data()), "H5Awrite");
}

std::string text_of(const Object& object, const std::string& name) {
  const Object attribute(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose, "H5Aopen");
  const Object type(H5Aget_type(attribute.id()), H5Tclose, "H5Aget_type");
  std::string text(H5Tget_size(type.id()), '\0');
  succeeded(H5Aread(attribute.id(), type.id(), text.data()), "H5Aread");
  return text.substr(0, text.find('\0'));
}

void remove_attribute(const Object& object, const std::string& name) {
  if (succeeded(H5Aexists(object.id(), name.c_str()), "H5Aexists") > 0)
    succeeded(H5Adelete(object.id(), name.c_str()), "H5Adelete");
}

void write_part(const Object& array, const std::vector<hsize_t>& start,
                const std::vector<hsize_t>& count, hid_t memory_type, const void* numbers) {
  const Object file_space(H5Dget_space(array.id()), H5Sclose, "H5Dget_space");
  succeeded(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr,
                                count.data(), nullptr),
            "H5Sselect_hyperslab");
  succeeded(
      H5Dwrite(array.id(), memory_type, space(count).id(), file_space.id(), H5P_DEFAULT, numbers),
      "H5Dwrite");
}

std::vector<unsigned char> read_bytes(const Object& array, std::size_t size) {
  std::vector<unsigned char> bytes(size);
  succeeded(H5Dread(array.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
            "H5Dread");
  return bytes;
}

void make_scale(const Object& array, const std::string& name) {
  succeeded(H5DSset_scale(array.id(), name.c_str()), "H5DSset_scale");
}

void attach_scale(const Object& array, const Object& scale, unsigned dimension) {
  succeeded(H5DSattach_scale(array.id(), scale.id(), dimension), "H5DSattach_scale");
}

}  // namespace vcrit::hdf5
