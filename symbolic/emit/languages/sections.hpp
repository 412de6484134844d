// The arithmetic of a language: the file arithmetic.* of its folder, which compiles as it is and is
// part of this program.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "program/program.hpp"

/// The text of languages/FOLDER/arithmetic.*; stands before all namespaces.
#define VCRIT_ARITHMETIC(folder)                                                                 \
  extern "C" const char vcrit_arithmetic_##folder[], vcrit_arithmetic_##folder##_end[];          \
  namespace vcrit::symbolic {                                                                    \
  static const Sections& folder##_sections() {                                                   \
    static const Sections all(std::string_view(                                                  \
        vcrit_arithmetic_##folder,                                                               \
        static_cast<std::size_t>(vcrit_arithmetic_##folder##_end - vcrit_arithmetic_##folder))); \
    return all;                                                                                  \
  }                                                                                              \
  }

namespace vcrit::symbolic {

class Sections {
 public:
  /// A section begins after a line "//: name" or "#: name" and ends before the next one. Those
  /// called "alone" are for the file by itself.
  explicit Sections(std::string_view text);

  const std::string& operator[](const std::string& name) const;

  /// The operations that few programs use, as far as this one uses them.
  std::string rare_operations(const Program& program) const;

 private:
  std::map<std::string, std::string> sections_;
};

}  // namespace vcrit::symbolic
