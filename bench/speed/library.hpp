// Code compiled while the program runs, each piece with its own flags, and loaded.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/numbers.hpp"
#include "run/compiler.hpp"

namespace vcrit::speed {

using vcrit::to_text;  // beside that of flags

/// x: columns; out: n values; extra: room for n values of each column and one more column.
using Function = void (*)(const double* const* x, std::size_t n, double* out, double* extra);

/// Flags for both compilers, the program's own sources in reach.
struct Flags {
  static std::vector<std::string> scalar();     ///< -O3 -march=native
  static std::vector<std::string> unsafe();     ///< the same with -ffast-math
  static std::vector<std::string> by_hand();    ///< IEEE, but no errno and no traps
  static std::vector<std::string> generated();  ///< the same without contraction
};
std::string to_text(const std::vector<std::string>& flags);

class Library {
 public:
  /// Throws std::runtime_error with what compiler or loader said.
  Library(const std::filesystem::path& compiler, const std::vector<std::string>& flags,
          const std::filesystem::path& source);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  Function function(const std::string& name) const;

 private:
  validation::PrivateFolder folder_;
  void* handle_ = nullptr;
};

/// The source of a method by hand: "real_loop.cpp".
std::filesystem::path peer_source(const std::string& name);

/// The program of that name in PATH. Throws InputError.
std::filesystem::path compiler_named(const std::string& name);

}  // namespace vcrit::speed
