// The driver program as C++.
#pragma once

#include <string>
#include <vector>

#include "accuracy/driver.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation::accuracy {

/// A way as statements over `sets`, `columns`, `omegas` and `out`.
struct Call {
  Way way;
  std::string values;
  std::string timed;  ///< what is timed, if it is something else
};

/// The calls of the generated library "scene".
const std::vector<Call>& generated_calls();
/// The relative error bounds that both its grades claim: "certified_bound", "fast_bound".
const std::vector<Call>& bound_calls();
/// Eq. 24 in complex numbers, and the derived formula, as they stand in the text.
const Call& complex_call();
const Call& pasted_call();

/// `nested` and `formula`: the derivation with its networks as complex stiffnesses, and the formula
/// as `vcrit derive` prints it. The numbers of a set are read in the order of `symbols`.
std::string driver_source(const Scene& scene, const symbolic::Derivation& nested,
                          const symbolic::Derivation& formula, const std::vector<Symbol>& symbols,
                          const std::vector<Call>& calls, bool has_generated);

}  // namespace vcrit::validation::accuracy
