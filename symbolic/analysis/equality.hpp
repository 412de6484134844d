// Whether two scenes have the same v*.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::symbolic {

struct Equality {
  enum class Scope {
    symbols,  ///< as functions of all symbols; equal names are one symbol
    values    ///< as functions of mu0, omega and du_z, with the elements' decimals put in
  };
  enum class Evidence {
    canonical_form,  ///< both written in the one form that a rational function has
    residues         ///< the same values at pseudo-random points of a finite field
  };
  bool equal = false;
  Scope scope = Scope::symbols;
  Evidence evidence = Evidence::canonical_form;
  double chance_of_error = 0;  ///< of two functions that differ; 0 for a canonical form

  /// Where v* differs; empty if equal.
  struct Counterexample {
    std::vector<std::pair<Symbol, double>> values;
    double first = 0, second = 0;  ///< v*, m/s
    double difference = 0;         ///< relative
  };
  std::optional<Counterexample> counterexample;
};

/// Compares as functions of the symbols; if these differ and both scenes give values to all their
/// elements, mass and ratio, as functions of omega with these. Throws ModelError where v* is no
/// formula of either scene: where surfaces part.
Equality compare(const Problem& a, const Problem& other);

/// What `vcrit derive A --equal B` prints.
std::string text_of(const Equality& comparison);
std::string json_of(const Equality& comparison);

}  // namespace vcrit::symbolic
