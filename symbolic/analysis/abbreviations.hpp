// The two names that make steps, limits and conditions short: g = K_n/K_t and Z = k_d - m omega^2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "derivation/model.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

struct Abbreviations {
  std::optional<Line> ratio;      ///< of an isotropic contact with a Poisson's ratio or a number
  std::optional<Line> stiffness;  ///< of a body under a drive with one spring from end to end

  /// Those that expressions have.
  std::vector<Line> used_by(const std::vector<GiNaC::ex>& expressions) const;
};

Abbreviations abbreviations(const Derivation& derivation);

/// The change with both names, with either, and as it is: what is shorter in none keeps its place
/// behind the others.
std::vector<Change> abbreviated(const Abbreviations& names, const Change& change);

/// Each + - * / ^ sqrt abs of an expression as it is printed.
int printed_operations(const GiNaC::ex& expression);

/// f of the change in the names in which its `length` is the least, the first of equal ones.
template <typename F, typename Length>
auto shortest_in(const Abbreviations& names, const Change& change, const F& f,
                 const Length& length) {
  std::vector<Change> changes = abbreviated(names, change);
  auto best = f(changes.front());
  int least = length(best);
  for (std::size_t i = 1; i < changes.size(); ++i) {
    auto other = f(changes[i]);
    if (const int operations = length(other); operations < least) {
      least = operations;
      best = std::move(other);
    }
  }
  return best;
}

}  // namespace vcrit::symbolic
