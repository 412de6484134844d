#include "maps/shared_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#ifdef VCRIT_WITH_MPI
#include <mpi.h>
#endif

namespace vcrit::maps {

namespace {

[[noreturn]] void fail() { throw std::runtime_error(std::strerror(errno)); }

/// Moves all bytes by a call that may move less: transfer(done) moves those from number `done` on.
template <class Transfer>
void all_of(std::size_t size, const Transfer& transfer) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t moved = transfer(done);
    if (moved < 0 && errno == EINTR) continue;
    if (moved < 0) fail();
    if (moved == 0) throw std::runtime_error("the file's end before the last number");
    done += static_cast<std::size_t>(moved);
  }
}

}  // namespace

#ifdef VCRIT_WITH_MPI

struct SharedFile::Handle {
  MPI_File file = MPI_FILE_NULL;
};

namespace {

void succeeded(int status) {
  if (status == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(status, text, &length);
  throw std::runtime_error(std::string(text, static_cast<std::size_t>(length)));
}

/// Open MPI calls it a success when a disk is full: what counts is how many bytes were moved.
template <class Transfer>
void all_at_once(std::size_t size, const Transfer& transfer) {
  errno = 0;
  MPI_Status status;
  succeeded(transfer(static_cast<int>(size), &status));
  int moved = 0;
  MPI_Get_elements(&status, MPI_BYTE, &moved);
  if (moved == static_cast<int>(size)) return;
  if (errno != 0) fail();
  throw std::runtime_error("fewer bytes than were to be read or written");
}

}  // namespace

#else

struct SharedFile::Handle {};

#endif

SharedFile::SharedFile(const std::filesystem::path& file, [[maybe_unused]] const Ranks& ranks) {
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ < 0) fail();
#ifdef VCRIT_WITH_MPI
  if (ranks.size() == 1) return;
  handle_ = std::make_unique<Handle>();
  succeeded(
      MPI_File_open(MPI_COMM_WORLD, file.c_str(), MPI_MODE_RDWR, MPI_INFO_NULL, &handle_->file));
#endif
}

SharedFile::~SharedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void SharedFile::read(std::uint64_t offset, void* bytes, std::size_t size) const {
#ifdef VCRIT_WITH_MPI
  if (handle_)
    return all_at_once(size, [&](int count, MPI_Status* status) {
      return MPI_File_read_at(handle_->file, static_cast<MPI_Offset>(offset), bytes, count,
                              MPI_BYTE, status);
    });
#endif
  all_of(size, [&](std::size_t done) {
    return ::pread(descriptor_, static_cast<char*>(bytes) + done, size - done,
                   static_cast<off_t>(offset + done));
  });
}

void SharedFile::write(std::uint64_t offset, const void* bytes, std::size_t size) const {
#ifdef VCRIT_WITH_MPI
  if (handle_)
    return all_at_once(size, [&](int count, MPI_Status* status) {
      return MPI_File_write_at(handle_->file, static_cast<MPI_Offset>(offset), bytes, count,
                               MPI_BYTE, status);
    });
#endif
  all_of(size, [&](std::size_t done) {
    return ::pwrite(descriptor_, static_cast<const char*>(bytes) + done, size - done,
                    static_cast<off_t>(offset + done));
  });
}

void SharedFile::begin_writing_out() const {
#ifdef SYNC_FILE_RANGE_WRITE
  ::sync_file_range(descriptor_, 0, 0, SYNC_FILE_RANGE_WRITE);
#endif
}

void SharedFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
#ifdef VCRIT_WITH_MPI
  if (handle_) succeeded(MPI_File_close(&handle_->file));
#endif
}

}  // namespace vcrit::maps
