#include "report/graph_layout.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace vcrit::validation::report {

namespace {

constexpr int terminals = 2;       // nodes 0 and 1 of every graph
constexpr double steepness = 1.2;  // rows are farther apart than columns: room for labels

std::vector<std::vector<int>> neighbours(const Graph& graph) {
  std::vector<std::vector<int>> result(graph.nodes.size());
  for (const Wire& wire : graph.wires) {
    result[static_cast<std::size_t>(wire.from)].push_back(wire.to);
    result[static_cast<std::size_t>(wire.to)].push_back(wire.from);
  }
  return result;
}

/// Edges from terminal 0 to each inner node without passing terminal 1; terminal 1 after them all.
std::vector<int> columns(const Graph& graph) {
  const auto next = neighbours(graph);
  std::vector<int> column(graph.nodes.size(), 0);
  std::vector<bool> seen(graph.nodes.size(), false);
  seen[0] = seen[1] = true;
  int last = 0;
  std::queue<int> open({0});
  for (; !open.empty(); open.pop())
    for (const int node : next[static_cast<std::size_t>(open.front())]) {
      const auto index = static_cast<std::size_t>(node);
      if (seen[index]) continue;
      seen[index] = true;
      column[index] = last = column[static_cast<std::size_t>(open.front())] + 1;
      open.push(node);
    }
  column[1] = last + 1;
  return column;
}

/// An edge over more than one column could run through a node on the line between the terminals.
bool has_long_edge(const Graph& graph, const std::vector<int>& column) {
  return std::any_of(graph.wires.begin(), graph.wires.end(), [&](const Wire& wire) {
    return std::abs(column[static_cast<std::size_t>(wire.from)] -
                    column[static_cast<std::size_t>(wire.to)]) > 1;
  });
}

}  // namespace

GraphLayout lay_out(const Graph& graph, double spacing) {
  const std::vector<int> column = columns(graph);
  const bool stagger = has_long_edge(graph, column);
  GraphLayout layout;
  layout.nodes.resize(graph.nodes.size());
  layout.width = spacing * column[1];
  layout.nodes[1] = {layout.width, 0};
  for (int i = 1; i < column[1]; ++i) {
    const auto in_column = std::count(column.begin() + terminals, column.end(), i);
    double y = -static_cast<double>(in_column - 1) / 2;
    if (stagger && in_column % 2 == 1) y += i % 2 == 1 ? -0.5 : 0.5;
    for (std::size_t node = terminals; node < column.size(); ++node)
      if (column[node] == i) {
        layout.nodes[node] = {spacing * i, steepness * spacing * y++};
        layout.reach = std::max(layout.reach, std::abs(layout.nodes[node].y));
      }
  }
  return layout;
}

}  // namespace vcrit::validation::report
