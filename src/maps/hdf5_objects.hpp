// The few objects of HDF5 that maps are made of. Every function throws hdf5::Error.
#pragma once

#include <hdf5.h>

#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vcrit::hdf5 {

/// HDF5 refused something; the message is the innermost one of its stack.
class Error : public std::runtime_error {
 public:
  explicit Error(const char* function);
};

/// What any function of HDF5 returned, unless it reports an error.
template <class Result>
Result succeeded(Result result, const char* function) {
  if (result < 0) throw Error(function);
  return result;
}

/// An identifier that closes itself.
class Object {
 public:
  using Close = herr_t (*)(hid_t);

  Object() = default;
  Object(hid_t id, Close how, const char* function) : id_(succeeded(id, function)), close_(how) {}
  Object(Object&& other) noexcept { swap(other); }
  Object& operator=(Object&& other) noexcept {
    swap(other);
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() {
    if (id_ >= 0) close_(id_);
  }
  /// Closes it now; what a destructor would hide is thrown.
  void close() {
    const hid_t id = std::exchange(id_, -1);
    if (id >= 0) succeeded(close_(id), "close");
  }
  /// Never closes it.
  void leave() { id_ = -1; }
  hid_t id() const { return id_; }

 private:
  void swap(Object& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// An array of numbers of one type whose space is set aside at once and left unwritten. The file
/// records no times, so that equal contents are equal bytes.
Object create_array(const Object& parent, const std::string& name, hid_t type,
                    const std::vector<hsize_t>& size);
Object create_group(const Object& parent, const std::string& name);
Object open_array(const Object& parent, const std::string& name);

void put(const Object& object, const std::string& name, const std::string& text);
/// One number or several, of a type in the file.
void put(const Object& object, const std::string& name, hid_t type, std::span<const double> values);
std::string text_of(const Object& object, const std::string& name);
void remove_attribute(const Object& object, const std::string& name);

/// The part of an array that begins at `start` and has `count` numbers along each dimension; the
/// memory holds doubles, or bytes.
void write_part(const Object& array, const std::vector<hsize_t>& start,
                const std::vector<hsize_t>& count, hid_t memory_type, const void* numbers);
std::vector<unsigned char> read_bytes(const Object& array, std::size_t size);

/// An array as the coordinate of a dimension, and what has that dimension.
void make_scale(const Object& array, const std::string& name);
void attach_scale(const Object& array, const Object& scale, unsigned dimension);

}  // namespace vcrit::hdf5
