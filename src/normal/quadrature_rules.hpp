// Nodes and weights of rules for integrals over (-1, 1), from Boost, whose headers take a compiler
// more than a second.
#pragma once

#include <cstddef>
#include <span>

namespace vcrit {

/// The nodes that are not below 0, the least first, and their weights; the rest mirrors them.
struct SymmetricRule {
  std::span<const double> nodes, weights;
};

/// Gauss's with 20 nodes, and with 30.
SymmetricRule gauss_20();
SymmetricRule gauss_30();

/// Of a rule without the node 0. The function is asked at each node before its mirror image.
template <class Function>
auto integral(const SymmetricRule& rule, double low, double high, const Function& function) {
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  decltype(function(low)) sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const auto above = function(middle + half * rule.nodes[i]);
    const auto below = function(middle - half * rule.nodes[i]);
    sum += (above + below) * rule.weights[i];
  }
  return sum * half;
}

/// Kronrod's with 21 nodes, 0 among them; those in odd places are Gauss's with 10.
SymmetricRule kronrod_21();
SymmetricRule gauss_10();

}  // namespace vcrit
