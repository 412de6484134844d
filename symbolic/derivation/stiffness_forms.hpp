// K(s) of a network with symbols, by running its reduction: as a ratio of polynomials, as a
// theorist would write it (nested), or only counted. Each can be taken to a limit, in which some
// elements grow or vanish: as every operation of a reduction adds, multiplies or divides positive
// quantities, leading terms never cancel, and it is enough to carry the leading term.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "formula/line.hpp"
#include "network/reduction.hpp"

namespace vcrit::symbolic {

/// Symbols that go with T^rate as T grows without end: 1 to infinity, -1 to zero, absent: stay. The
/// symbol omega takes s along.
using GrowthExponents = std::map<Symbol, int>;

/// value T^power is the leading term of K(s).
template <class Value>
struct Leading {
  int power = 0;
  Value value{};
};

/// numerator/denominator, polynomials in s and the elements.
struct Fraction {
  Expression numerator, denominator;
};

/// How many terms numerator and denominator have when multiplied out: exact where no element occurs
/// twice, an upper bound elsewhere.
struct TermCount {
  double numerator = 0, denominator = 0;
};

Leading<Fraction> fraction(const Reduction& reduction, const GrowthExponents& rates);
Leading<TermCount> term_count(const Reduction& reduction, const GrowthExponents& rates);
/// Results used twice and long chains get names K_1, K_2, ... which are appended to `definitions`.
Leading<GiNaC::ex> nested(const Reduction& reduction, const GrowthExponents& rates,
                          std::vector<Line>& definitions);

}  // namespace vcrit::symbolic
