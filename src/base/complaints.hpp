// What is wrong with an input: told at once, as commands need it, or collected, for who wants to
// hear all of it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace vcrit {

/// What is suspicious and stops nothing.
struct Warning {
  Place place;
  std::string text;
};

/// "file:12:5: text"
std::string to_text(const Warning& warning);

/// Who reads adds each complaint and goes on with the next part: `add` comes back only where
/// complaints are collected.
class Complaints {
 public:
  enum class Mode { first, all };
  explicit Complaints(Mode mode = Mode::first) : mode_(mode) {}

  /// Throws it, or keeps it: once, if it comes from a line that is not ignored.
  void add(const InputError& complaint);
  /// Reads a part of the input. Returns whether nothing was wrong with it; where the first
  /// complaint counts, that is thrown.
  template <class Part>
  bool attempt(const Part& part) {
    if (mode_ == Mode::first) {
      part();
      return true;
    }
    try {
      part();
      return true;
    } catch (const InputError& complaint) {
      add(complaint);
      return false;
    }
  }
  /// Of a line that has been complained of as a whole nothing more is told.
  void ignore_line(int line) { ignored_.insert(line); }

  bool collects() const { return mode_ == Mode::all; }
  bool any() const { return !all_.empty(); }
  /// By line and column; those without a line first.
  std::vector<InputError> sorted() const;

 private:
  Mode mode_;
  std::vector<InputError> all_;
  std::set<std::string> told_;
  std::set<int> ignored_;
};

}  // namespace vcrit
