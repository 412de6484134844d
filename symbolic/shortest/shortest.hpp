// The shortest real formula of v* = mu0 omega du_z |K_n|/|K_t| |K_t + D|/|D|, D = K_d - m omega^2,
// in named steps: the letters that people use (g = K_n/K_t, Z + i V = D, T = omega tau, W = omega
// c), then what is used more than once. Several ways to write the networks (storage and loss, one
// denominator, compliances) are begun with, and each is shortened by moves of algebra; of all, the
// one with the fewest + - * / ^ sqrt abs is taken.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// The same in every run. Nothing where it would not fit a page: who asks for v* is better served
/// by a formula in complex stiffnesses. Nor of a measured drive, which has no other one.
std::optional<ShortestForm> shortest_form(const Problem& problem);

/// Each + - * / ^ sqrt abs.
int operations_in(const Form& form);

}  // namespace vcrit::symbolic
