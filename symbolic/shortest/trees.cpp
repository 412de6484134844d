#include "shortest/trees.hpp"

#include <algorithm>

namespace vcrit::symbolic::shortest {

namespace {

constexpr std::size_t most_sums = 2000;

}  // namespace

Trees::Trees(ComplexAlgebra& algebra, const Graph& graph, const std::vector<ComplexEx>& edges,
             Order order)
    : algebra_(algebra), order_(order) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges_.push_back({graph.wires[i].from, graph.wires[i].to, edges[i]});
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) nodes_.push_back(static_cast<int>(i));
}

ComplexQuotient Trees::stiffness() {
  Edges joined = edges_;
  for (Edge& edge : joined) {
    if (edge.from == 1) edge.from = 0;
    if (edge.to == 1) edge.to = 0;
  }
  std::vector<int> nodes = nodes_;
  std::erase(nodes, 1);
  return {sum(edges_, nodes_), sum(std::move(joined), std::move(nodes))};
}

Trees::Edges Trees::merged(const Edges& edges) {
  Edges result;
  for (Edge edge : edges) {
    if (edge.from == edge.to) continue;
    if (edge.from > edge.to) std::swap(edge.from, edge.to);
    const auto same = std::find_if(result.begin(), result.end(), [&](const Edge& each) {
      return each.from == edge.from && each.to == edge.to;
    });
    if (same == result.end())
      result.push_back(edge);
    else
      same->stiffness = algebra_.add(same->stiffness, edge.stiffness);
  }
  return result;
}

std::size_t Trees::chosen(const Edges& edges) const {
  if (order_ == Order::backwards) return edges.size() - 1;
  if (order_ == Order::as_written) return 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (edges[i].from >= 2 && edges[i].to >= 2) return i;
  return 0;
}

ComplexEx Trees::split(const Edges& edges, const std::vector<int>& nodes, std::size_t at) {
  const Edge edge = edges[at];
  Edges with;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i == at) continue;
    Edge moved = edges[i];
    if (moved.from == edge.to) moved.from = edge.from;
    if (moved.to == edge.to) moved.to = edge.from;
    with.push_back(moved);
  }
  std::vector<int> left = nodes;
  std::erase(left, edge.to);
  return algebra_.multiply(edge.stiffness, sum(std::move(with), std::move(left)));
}

ComplexEx Trees::sum(Edges edges, std::vector<int> nodes) {
  if (++sums_ > most_sums) throw TooLarge{};
  if (nodes.size() == 1) return from_real(Expressions::number(1));
  edges = merged(edges);
  std::size_t lone = edges.size();
  for (const int node : nodes) {
    std::size_t degree = 0, last = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (edges[i].from == node || edges[i].to == node) ++degree, last = i;
    if (degree == 0) return {};
    if (degree == 1) lone = last;
  }
  // All trees have the only edge of a node.
  if (lone < edges.size()) return split(edges, nodes, lone);
  const std::size_t at = chosen(edges);
  const ComplexEx with = split(edges, nodes, at);
  edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(at));
  return algebra_.add(with, sum(std::move(edges), std::move(nodes)));
}

}  // namespace vcrit::symbolic::shortest
