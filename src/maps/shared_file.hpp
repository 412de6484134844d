// A file that every rank writes, each where its blocks are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "maps/ranks.hpp"

namespace vcrit::maps {

/// By the system's own calls, or, for several ranks, by those of MPI, which keep what two machines
/// write beside each other apart on any file system. Every function throws std::runtime_error in
/// the system's words.
class SharedFile {
 public:
  /// Opens a file that is there; called by all ranks together.
  SharedFile(const std::filesystem::path& file, const Ranks& ranks);
  /// Several ranks close a file together: one that fails alone must not wait there for the others,
  /// who wait for it.
  ~SharedFile();
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;

  void read(std::uint64_t offset, void* bytes, std::size_t size) const;
  void write(std::uint64_t offset, const void* bytes, std::size_t size) const;
  /// Tells the system to begin with what waits for the disk, without waiting for it.
  void begin_writing_out() const;
  /// By all ranks together.
  void close();

 private:
  struct Handle;  // of MPI
  std::unique_ptr<Handle> handle_;
  int descriptor_ = -1;
};

}  // namespace vcrit::maps
