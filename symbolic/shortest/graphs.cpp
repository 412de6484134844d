#include "shortest/graphs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace vcrit::symbolic::shortest {

namespace {

class Joining {
 public:
  explicit Joining(const Graph& graph) {
    for (std::size_t i = 0; i < graph.wires.size(); ++i) {
      const auto [from, to] = graph.wires[i];
      edges_.push_back({std::min(from, to), std::max(from, to), graph.parts[i]});
    }
    for (int node = 2; node < static_cast<int>(graph.nodes.size()); ++node) inner_.push_back(node);
  }

  Network network() {
    while (join_side_by_side() || join_in_line()) continue;
    std::vector<Network> direct;
    for (const Edge& edge : edges_)
      if (edge.from == 0 && edge.to == 1) direct.push_back(edge.part);
    std::erase_if(edges_, [](const Edge& edge) { return edge.from == 0 && edge.to == 1; });
    if (!edges_.empty()) direct.push_back({rest()});
    return parallel(std::move(direct));
  }

 private:
  struct Edge {
    int from, to;
    Network part;
  };

  bool join_side_by_side() {
    for (auto a = edges_.begin(); a != edges_.end(); ++a)
      for (auto b = a + 1; b != edges_.end(); ++b)
        if (a->from == b->from && a->to == b->to) {
          a->part = parallel({std::move(a->part), std::move(b->part)});
          edges_.erase(b);
          return true;
        }
    return false;
  }

  bool join_in_line() {
    for (auto node = inner_.begin(); node != inner_.end(); ++node) {
      std::vector<std::size_t> at;
      for (std::size_t i = 0; i < edges_.size(); ++i)
        if (edges_[i].from == *node || edges_[i].to == *node) at.push_back(i);
      if (at.size() != 2) continue;
      Edge &a = edges_[at[0]], &b = edges_[at[1]];
      const int from = a.from + a.to - *node, to = b.from + b.to - *node;
      a = {std::min(from, to), std::max(from, to), series({std::move(a.part), std::move(b.part)})};
      edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(at[1]));
      inner_.erase(node);
      return true;
    }
    return false;
  }

  Graph rest() const {
    Graph graph{std::vector<std::string>(2 + inner_.size()), {}, {}};
    const auto number = [this](int node) {
      const auto found = std::find(inner_.begin(), inner_.end(), node);
      return node < 2 ? node : 2 + static_cast<int>(found - inner_.begin());
    };
    for (const Edge& edge : edges_) {
      graph.parts.push_back(edge.part);
      graph.wires.push_back({number(edge.from), number(edge.to)});
    }
    return graph;
  }

  std::vector<Edge> edges_;
  std::vector<int> inner_;
};

}  // namespace

Network series_parallel(const Graph& graph) { return Joining(graph).network(); }

}  // namespace vcrit::symbolic::shortest
