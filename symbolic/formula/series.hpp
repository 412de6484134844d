// Long series as people write them: k[1]/T1 + k[2]/T2 + ... + k[10]/T10 is a sum over an index, and
// ten definitions that differ by a number are one, for j = 1 to 10.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formula/form.hpp"

namespace vcrit::symbolic {

/// The form with sums over an index for terms, four or more, that differ by one number alone: that
/// of entries of arrays (k[3]) and of numbered letters of the program (T3).
Form with_series(Form form);

/// What two forms of a series have in common, and the number in which they differ.
struct SeriesMember {
  std::string pattern;
  int number = 0;
  Form general;  ///< with the index for the number
};

/// Nothing for a form without a number.
std::optional<SeriesMember> series_member(const Form& form);

/// The letter of the index: j, or another one where the scene has that.
std::string series_index();

/// Shorter runs are written out.
inline constexpr int shortest_series = 4;

}  // namespace vcrit::symbolic
