// The named rheologies that may stand wherever a network does.
#pragma once

#include <string>
#include <vector>

#include "network/network.hpp"

namespace vcrit {

/// One named rheology: `kelvin(k, c)` with its arguments in order. A plain argument is a scalar
/// element; those of `prony` that are arrays are marked.
struct Rheology {
  enum class Argument { scalar, array };
  std::string name;
  std::string called;   ///< in the literature
  std::string meaning;  ///< a sentence or two
  std::vector<std::pair<std::string, Argument>> arguments;
  /// The network of the argument names; `branches` is the length of the arrays.
  Network (*build)(const std::vector<std::string>& names, int branches);

  bool has_arrays() const;
  std::string signature() const;  ///< "kelvin(k, c)"
};

const std::vector<Rheology>& catalogue();

}  // namespace vcrit
