// The named rheologies that may stand wherever a network does.
#pragma once

#include <string>
#include <vector>

#include "network/network.hpp"

namespace vcrit {

/// One named rheology: `kelvin(k, c)` with its arguments in order. A plain argument is a scalar
/// element; those that are arrays are marked.
struct Rheology {
  enum class Argument { scalar, array };
  std::string name;
  std::string called;   ///< in the literature
  std::string meaning;  ///< a sentence or two
  std::vector<std::pair<std::string, Argument>> arguments;
  /// The network of the argument names; `branches` is the length of the arrays.
  Network (*build)(const std::vector<std::string>& names, int branches);
  std::vector<std::string> also = {};  ///< other names by which scenes may call it
  bool is_nested = false;              ///< each branch is inside the one before it

  bool has_arrays() const;
  bool in_drives_only() const;                   ///< since it has masses
  bool goes_by(const std::string& other) const;  ///< whether that is one of its names
  /// "kelvin(k, c)"; by another of its names where one is given.
  std::string signature(const std::string& other = "") const;
};

const std::vector<Rheology>& catalogue();

}  // namespace vcrit
