// Eq. 24 derived for a scene: the harmonic balance of contact point (19) and body (13) is set up
// and solved by GiNaC, the scene's networks are put in, and the result is brought to one form that
// does not depend on the run.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace vcrit::symbolic {

/// One line of mathematics with the words that lead to it.
struct Line {
  std::string words;
  GiNaC::ex left, right;  ///< left = right
};

struct Derivation {
  std::vector<Line> lines;         ///< from the equations of motion to the result
  GiNaC::ex normal, tangential;    ///< K_n(i omega), K_t(i omega)
  std::optional<GiNaC::ex> drive;  ///< K_d(i omega)
  GiNaC::ex critical_velocity;     ///< v*, real, in the scene's symbols (and in definitions)
  std::vector<Line> definitions;   ///< names in critical_velocity where it is too large to be
                                   ///< multiplied out: K_1, ..., K_n, as functions of s, in order
  std::string equation;            ///< number in the paper: "(24)", or of a special case
  std::vector<Symbol> parameters;  ///< the symbols v* depends on
};

/// A formula of up to about two dozen terms in each polynomial is multiplied out; a larger one
/// stays nested, in terms of K_n, K_t, K_d and further inner quantities.
Derivation derive(const Scene& scene);

/// Symbols that go with T^rate as T grows without end: 1 to infinity, -1 to zero, absent: stay.
using Rates = std::map<Symbol, int>;

/// A limit or special case of v* that applies to the scene.
struct Limit {
  std::string name;  ///< "kd -> infinity", say
  std::string latex_name;
  std::string equation;  ///< number in the paper, "(31)", where it is one, else empty
  GiNaC::ex result;
  std::vector<Line> definitions;  ///< as in Derivation
  Rates rates;                    ///< a way to approach it; empty where values alone do not
};

/// Drive to rigid, mass to 0, each damper to 0 and to infinity, all dampers to 0, then the drive to
/// rigid, and the isotropic contact where both networks have one shape. Left out: limits that cut a
/// network in two, in which the normal force grows without end, or in which nothing is left that
/// moves.
std::vector<Limit> limits(const Scene& scene);

/// A formula's value; `values` holds every parameter. Carries the digits of GiNaC::Digits.
GiNaC::numeric value_at(const GiNaC::ex& formula, const std::vector<Line>& definitions,
                        const std::map<Symbol, GiNaC::numeric>& values);

}  // namespace vcrit::symbolic
