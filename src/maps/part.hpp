// An unfinished sweep is OUT.part, a table or an array: one run at a time writes it, and in the end
// it gets the name OUT.
#pragma once

#include <filesystem>
#include <string>

#include "base/made_folders.hpp"

namespace vcrit::maps {

/// OUT.part
std::filesystem::path part_of(const std::filesystem::path& file);

/// What is wrong with the part, and what to do then: nothing more by default.
[[noreturn]] void refuse_part(const std::filesystem::path& part, const std::string& found,
                              const std::string& next_step = {});

/// The next step where what is written by then stays.
inline constexpr const char* goes_on = "`resume` goes on from here";

class PartFile {
 public:
  /// Of several runs that begin, or go on, at one moment exactly one gets the part. Throws
  /// InputError where another one holds it, where a link stands in its place, and where there is an
  /// unfinished sweep but no `resume`.
  PartFile(const std::filesystem::path& file, bool resume);

  /// Whether there is an unfinished sweep.
  bool is_there() const;
  /// Gives the part its last name.
  void put_into_place();
  void remove();

 private:
  /// On OUT.part.lock, advisory, which the system lets go however the program ends.
  class Lock {
   public:
    explicit Lock(const std::filesystem::path& part);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

   private:
    std::filesystem::path file_;
    int descriptor_ = -1;  // negative where the place knows no locks
  };

  std::filesystem::path file_, path_;
  MadeFolders folders_;
  Lock lock_;
};

}  // namespace vcrit::maps
