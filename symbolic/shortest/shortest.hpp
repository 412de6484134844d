// The shortest real formula of v* = mu0 omega du_z |K_n|/|K_t| |K_t + D|/|D|, D = K_d - m omega^2,
// in named steps: the letters that people use (g = K_n/K_t, Z + i V = D, T = omega tau, W = omega
// c), then what is used more than once. Several ways to write the networks (storage and loss, one
// denominator, compliances) are begun with, and each is shortened by moves of algebra; of all, the
// one with the fewest + - * / ^ sqrt abs is taken. All of it is tried with omega in front and in
// letters, as people have it, and once more with omega as a factor like others: v* = mu0 du_z
// |...|, multiplied through by omega, is taken where it is shorter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dimensionless.hpp"
#include "formula/form.hpp"
#include "formula/prose.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

struct ShortestForm {
  struct Definition {
    Form name, meaning;
  };
  std::vector<Definition> definitions;  ///< each of earlier ones
  Form velocity;
  Prose ratio;         ///< where K_n/K_t of an isotropic contact comes from; else empty
  int operations = 0;  ///< each + - * / ^ sqrt abs in all of it
};

/// A form, or why there is none.
struct FoundForm {
  std::optional<ShortestForm> form;
  std::string why_none;  ///< part of a sentence, with the numbers that decided
};

/// The same in every run. None where it would not fit a page: who asks for v* is better served by a
/// formula in complex stiffnesses. Nor of a measured drive, which has no other one.
FoundForm find_shortest_form(const Problem& problem);
std::optional<ShortestForm> shortest_form(const Problem& problem);

/// The same in the groups of the problem.
FoundForm find_dimensionless_form(const Problem& problem, const DimensionlessGroups& groups);

}  // namespace vcrit::symbolic
