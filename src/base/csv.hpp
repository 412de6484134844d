// Tables in CSV, line by line, each with its place for messages.
#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace vcrit {

class CsvLines {
 public:
  /// `text` of the file named `file`, with or without a byte order mark. Throws InputError where
  /// that is one of UTF-16.
  CsvLines(const std::string& text, const std::string& file);

  /// Takes the first line. Throws InputError with the advice unless its cells are those of
  /// `header`, "x,y".
  void take_header(const char* header, const char* advice = "");

  /// The next line with more than blanks on it; false at the end. Line ends of Windows do no harm.
  bool next();
  const std::string& line() const { return line_; }
  const Place& place() const { return place_; }

  /// What stands between commas, without blanks around it and quotes around the whole.
  std::vector<std::string> cells() const;
  /// The same as finite numbers. Throws InputError with the line; `expected` says what `count`
  /// numbers should be there.
  std::vector<double> numbers(std::size_t count, const std::string& expected) const;

 private:
  std::istringstream in_;
  std::string line_;
  Place place_;
};

}  // namespace vcrit
