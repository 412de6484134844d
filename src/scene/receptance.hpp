// A drive that was measured: its receptance, displacement over force at the end that the body hangs
// on, at some angular frequencies. Between two rows real and imaginary part are linear in omega.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace vcrit {

struct Receptance {
  struct Row {
    double omega = 0;       ///< rad/s
    double re = 0, im = 0;  ///< m/N
    int line = 0;           ///< of the file; 0 where unknown
    friend bool operator==(const Row& a, const Row& b) {
      return a.omega == b.omega && a.re == b.re && a.im == b.im;
    }
  };
  std::string file;
  std::vector<Row> rows;  ///< at least two, omega increasing
  // Of what moves in time like it (realisation/realisation.hpp), where they are given:
  std::optional<double> static_compliance = {};  ///< at rest, m/N
  std::optional<int> order = {};                 ///< pairs of oscillating motions
};

/// The greatest order; more pairs than that no table tells apart.
constexpr int most_order = 12;

/// Where an angular frequency lies: between `below` and `above`, which may be equal.
struct Bracket {
  Receptance::Row below, above;
};

/// Throws ModelError for an omega (rad/s) outside the table, InputError where that has no rows.
Bracket bracket(const Receptance& receptance, double omega);

/// Reads a table in CSV with the header omega,Re,Im. Throws InputError with file and line, or with
/// `place`, where the file is named, if there is none.
Receptance read_receptance(const std::string& file, const Place& place);
/// The same from text; `file` only names it in messages.
Receptance parse_receptance(const std::string& text, const std::string& file);

}  // namespace vcrit
