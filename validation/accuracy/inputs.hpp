// Parameter sets around a scene, the same in every run: each parameter log-uniform in the decade
// around its value, and in a part of them omega close to where Eq. 24 cancels.
#pragma once

#include <cstdint>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::validation::accuracy {

struct Inputs {
  std::uint64_t seed = 0;                                  ///< of std::mt19937_64
  std::vector<Symbol> symbols;                             ///< what varies
  std::vector<std::vector<double>> sets;                   ///< their values, SI
  std::size_t near_resonance = 0, near_antiresonance = 0;  ///< how many of the sets
};

/// In every fourth set omega is within a relative 1e-2 to 1e-12 (log-uniform) of a resonance, in
/// every fourth of an antiresonance, where the scene has them. In a measured drive's table omega
/// stays inside.
Inputs draw_inputs(const Problem& problem, const std::vector<Symbol>& symbols, std::size_t size,
                   std::uint64_t seed);

}  // namespace vcrit::validation::accuracy
