#include "network/reduction.hpp"
#include "network/wiring.hpp"

#include <fmt/core.h>

#include <map>
#include <set>

namespace vcrit {

namespace {

class Reducer {
 public:
  std::size_t reduce(const Network& network) {
    return std::visit([this](const auto& form) { return (*this)(form); }, network.form);
  }

  std::vector<Step> steps;

 private:
  std::size_t operator()(const Element& element) {
    return add({Step::Kind::element, element, 0, 0, 0});
  }
  std::size_t operator()(const Series& series) { return fold(series.parts, Step::Kind::series); }
  std::size_t operator()(const Parallel& parallel) {
    return fold(parallel.parts, Step::Kind::parallel);
  }
  std::size_t operator()(const Graph& graph);

  std::size_t add(Step step) {
    if (steps.size() == most_reduction_steps)
      throw InputError({"a graph"},
                       fmt::format("more than {} steps to its stiffness", most_reduction_steps),
                       "fewer edges between its inner nodes");
    steps.push_back(std::move(step));
    return steps.size() - 1;
  }
  std::size_t combine(Step::Kind kind, std::size_t a, std::size_t b) {
    return add({kind, {}, a, b, 0});
  }
  std::size_t fold(const std::vector<Network>& parts, Step::Kind kind) {
    std::size_t whole = reduce(parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i) whole = combine(kind, whole, reduce(parts[i]));
    return whole;
  }

  // The edges of what is left of a graph: neighbour -> step, for each node.
  using Edges = std::vector<std::map<std::size_t, std::size_t>>;
  void connect(Edges& edges, std::size_t from, std::size_t to, std::size_t step) {
    const auto [known, is_new] = edges[from].try_emplace(to, step);
    if (!is_new) known->second = combine(Step::Kind::parallel, known->second, step);
    edges[to][from] = edges[from][to];
  }
  void eliminate(Edges& edges, std::size_t node);
};

std::size_t Reducer::operator()(const Graph& graph) {
  Edges edges(graph.nodes.size());
  for (std::size_t i = 0; i < graph.wires.size(); ++i)
    connect(edges, static_cast<std::size_t>(graph.wires[i].from),
            static_cast<std::size_t>(graph.wires[i].to), reduce(graph.parts[i]));

  std::set<std::pair<std::size_t, std::size_t>> by_degree;
  for (std::size_t node = 2; node < edges.size(); ++node)
    by_degree.emplace(edges[node].size(), node);
  while (!by_degree.empty()) {
    const std::size_t node = by_degree.begin()->second;
    by_degree.erase(by_degree.begin());
    const auto neighbours = edges[node];
    for (const auto& [n, step] : neighbours)
      if (n >= 2) by_degree.erase({edges[n].size(), n});
    eliminate(edges, node);
    for (const auto& [n, step] : neighbours)
      if (n >= 2) by_degree.emplace(edges[n].size(), n);
  }
  const auto whole = edges[0].find(1);
  if (whole == edges[0].end())
    throw InputError(argument("network"), "a graph whose terminals are not connected",
                     "a path of wires between its first two nodes");
  return whole->second;
}

void Reducer::eliminate(Edges& edges, std::size_t node) {
  const std::vector<std::pair<std::size_t, std::size_t>> star(edges[node].begin(),
                                                              edges[node].end());
  if (star.size() < 2)
    throw InputError(argument("network"),
                     fmt::format("a graph with a part that leads nowhere, at node {}", node),
                     "edges on paths between the terminals alone, as load_carrying() leaves them");
  for (const auto& [n, step] : star) edges[n].erase(node);
  edges[node].clear();
  if (star.size() == 2)
    return connect(edges, star[0].first, star[1].first,
                   combine(Step::Kind::series, star[0].second, star[1].second));
  std::size_t total = star[0].second;
  for (std::size_t i = 1; i < star.size(); ++i)
    total = combine(Step::Kind::parallel, total, star[i].second);
  for (std::size_t i = 0; i < star.size(); ++i)
    for (std::size_t j = i + 1; j < star.size(); ++j)
      connect(edges, star[i].first, star[j].first,
              add({Step::Kind::mesh, {}, star[i].second, star[j].second, total}));
}

}  // namespace

Reduction reduce(const Network& network) {
  check_wiring(network);
  Reducer reducer;
  reducer.reduce(network);
  return {std::move(reducer.steps)};
}

}  // namespace vcrit
