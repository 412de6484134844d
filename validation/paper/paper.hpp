// The paper, checked: Zughaibi, Schulze, Li, Critical velocity of controllability of sliding
// friction by normal oscillations for an arbitrary linear rheology, Physical Mesomechanics 2018.
#pragma once

#include "compare/agreement.hpp"
#include "paper/contents.hpp"

namespace vcrit::validation::paper {

/// A few seconds.
Paper go_through(const Progress& progress);

/// What the paper says against what the parts found.
std::vector<Claim> judge(const Paper& paper);

}  // namespace vcrit::validation::paper
