// The three ways in which something can be wrong, kept apart because the program answers them
// differently: the input is wrong (exit status 2), the scene is well formed but outside the model
// (exit status 3), or the program itself has a bug.
#pragma once

#include <stdexcept>
#include <string>

namespace vcrit {

/// Where something stands in the input. Line and column count from 1; 0 means unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:12:5", with the parts that are known.
std::string to_text(const Place& place);

/// Wrong input: says where, what was found, and what was expected instead, each as printable() has
/// it (messages.hpp).
class InputError : public std::runtime_error {
 public:
  InputError(const Place& place, const std::string& found, const std::string& expected);
};

/// A well-formed scene that the model does not cover (not admissible, 0/0, ...).
class ModelError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A broken promise inside the program; never the user's fault. (clang 14 has no source_location.)
class Bug : public std::logic_error {
 public:
  explicit Bug(const std::string& what, const char* function = __builtin_FUNCTION(),
               int line = __builtin_LINE());
};

/// Throws Bug unless `holds`.
void ensure(bool holds, const char* what, const char* function = __builtin_FUNCTION(),
            int line = __builtin_LINE());

}  // namespace vcrit
