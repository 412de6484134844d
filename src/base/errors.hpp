// The three ways in which something can be wrong, kept apart because the program answers them
// differently: the input is wrong (exit status 2), the scene is well formed but outside the model
// (exit status 3), or the program itself has a bug.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace vcrit {

/// Where something stands in the input. Line and column count from 1; 0 means unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string argument = {};  ///< of the call, in place of a file: "velocity", "set k1"
};

/// An argument of the call: the program's option of that name, Python's keyword.
Place argument(const std::string& name);

/// "file:12:5", with the parts that are known, or the argument.
std::string to_text(const Place& place);

/// Wrong input: says where, what was found, what was expected instead, and what to do where that is
/// more. what() has each as printable() has it (messages.hpp), the parts are the bytes that came.
class InputError : public std::runtime_error {
 public:
  InputError(const Place& place, const std::string& found, const std::string& expected,
             const std::string& advice = "");

  const Place& place() const { return parts_->place; }
  const std::string& found() const { return parts_->found; }
  const std::string& expected() const { return parts_->expected; }
  const std::string& advice() const { return parts_->advice; }  ///< may be empty

 private:
  struct Parts {
    Place place;
    std::string found, expected, advice;
  };
  std::shared_ptr<const Parts> parts_;  // exceptions are copied without throwing
};

/// A well-formed scene that the model does not cover (not admissible, 0/0, ...), and what to do
/// where there is something.
class ModelError : public std::runtime_error {
 public:
  explicit ModelError(const std::string& what, const std::string& advice = "");

  const std::string& advice() const { return *advice_; }  ///< may be empty; what() ends in it

 private:
  std::shared_ptr<const std::string> advice_;
};

/// A broken promise inside the program; never the user's fault. It says in which function, not in
/// which line: each line of comment would make another program. (clang 14 has no source_location.)
class Bug : public std::logic_error {
 public:
  explicit Bug(const std::string& what, const char* function = __builtin_FUNCTION());
};

/// Throws Bug unless `holds`.
void ensure(bool holds, const char* what, const char* function = __builtin_FUNCTION());

}  // namespace vcrit
