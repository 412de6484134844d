// A measured profile of an axisymmetric indenter: height f over the tip at radius r, straight lines
// between the rows. It ends at its last radius, as a punch does.
#pragma once

#include <string>
#include <vector>

#include "base/errors.hpp"

namespace vcrit {

struct Profile {
  struct Row {
    double r = 0, f = 0;  ///< m
    friend bool operator==(const Row&, const Row&) = default;
  };
  std::string file;
  std::vector<Row> rows;  ///< at least two from (0, 0) on, r increasing, f never decreasing
};

/// Reads a table in CSV with the header r,f. Throws InputError with file and line, or with `place`,
/// where the file is named, if there is none.
Profile read_profile(const std::string& file, const Place& place);
/// The same from text; `file` only names it in messages.
Profile parse_profile(const std::string& text, const std::string& file);

}  // namespace vcrit
