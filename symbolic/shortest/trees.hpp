// The stiffness of a graph between its terminals as a quotient of sums over spanning trees
// (Kirchhoff): over, those of the graph, under, those of the graph with its terminals joined.
#pragma once

#include <cstddef>
#include <vector>

#include "network/network.hpp"
#include "shortest/complex.hpp"

namespace vcrit::symbolic::shortest {

class Trees {
 public:
  /// Which edge the sum is split by, trees with it and trees without it.
  enum class Order { inner_first, as_written, backwards };
  /// `edges`: the stiffness of each of the graph's.
  Trees(ComplexAlgebra& algebra, const Graph& graph, const std::vector<ComplexEx>& edges,
        Order order);
  /// Throws TooLarge for graphs that nobody would write out.
  ComplexQuotient stiffness();

 private:
  struct Edge {
    int from = 0, to = 0;
    ComplexEx stiffness;
  };
  using Edges = std::vector<Edge>;

  ComplexEx sum(Edges edges, std::vector<int> nodes);
  ComplexEx split(const Edges& edges, const std::vector<int>& nodes, std::size_t at);
  /// The edges between the same nodes joined, those from a node to itself left out.
  Edges merged(const Edges& edges);
  std::size_t chosen(const Edges& edges) const;

  ComplexAlgebra& algebra_;
  Edges edges_;
  std::vector<int> nodes_;
  Order order_;
  std::size_t sums_ = 0;
};

}  // namespace vcrit::symbolic::shortest
