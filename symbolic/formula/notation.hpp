// How a name is set in mathematics: greek letters, indices (k0 -> k with index 0, mu0, u_z0, k[3]).
#pragma once

#include <string>
#include <vector>

namespace vcrit::symbolic {

/// A name taken apart. `base` is one letter, the English name of a greek one, or a long word.
struct Notation {
  std::string before;  ///< "Delta" in front of du_z, "d" of dK_n, else empty
  std::string base;
  std::vector<std::string> index;  ///< parts of the lower index
  std::string above;               ///< "*" of v*, dots of derivatives
  std::string primes;              ///< of storage K_n' and loss K_n''
};

/// An entry of an array is an index as others, or in parentheses where that is another name.
Notation notation(const std::string& name, bool bare_entry = true);

bool is_greek(const std::string& word);

/// Whether a name is set as S with the name of a parameter as its index: S_k0.
bool is_sensitivity(const std::string& name);

}  // namespace vcrit::symbolic
