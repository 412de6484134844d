// Eq. 24 derived for a scene: the harmonic balance of contact point (19) and body (13) is set up and
// solved by GiNaC, the scene's networks are put in, and the result is brought to one form that does
// not depend on the run.
#pragma once

#include <ginac/ginac.h>

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
  std::vector<Line> lines;               ///< from the equations of motion to the result
  GiNaC::ex normal, tangential;          ///< K_n(i omega), K_t(i omega) as rational functions
  std::optional<GiNaC::ex> drive;        ///< K_d(i omega)
  GiNaC::ex critical_velocity;           ///< v*, real, in the scene's symbols
  std::vector<Symbol> parameters;        ///< the symbols v* depends on
};

Derivation derive(const Scene& scene);

/// A limit of v* that applies to the scene.
struct Limit {
  std::string name;      ///< "k_d -> infinity", say
  std::string equation;  ///< number in the paper, "(31)", where it is one of its equations, else empty
  GiNaC::ex result;
};

std::vector<Limit> limits(const Scene& scene);

}  // namespace vcrit::symbolic
