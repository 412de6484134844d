#include "stiffness/condensation.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace vcrit {

namespace {

using Chain = std::vector<Relaxation>;  // in series

class Condensing {
 public:
  explicit Condensing(const RelaxationGraph& graph) : chains_(graph.nodes) {
    for (std::size_t i = 0; i < graph.edges.size(); ++i)
      connect(static_cast<std::size_t>(graph.wires[i].from),
              static_cast<std::size_t>(graph.wires[i].to), {graph.edges[i]});
    for (std::size_t node = 2; node < chains_.size(); ++node) look_at(node);
  }

  RelaxationGraph run() {
    while (!in_a_row_.empty()) {
      const std::size_t node = in_a_row_.back();
      in_a_row_.pop_back();
      if (chains_[node].size() == 2) join_at(node);
    }
    return left();
  }

 private:
  // Both nodes know the chain; it is kept at the lower one.
  Chain& chain(std::size_t a, std::size_t b) { return chains_[std::min(a, b)][std::max(a, b)]; }

  void connect(std::size_t a, std::size_t b, Chain parts) {
    Chain& known = chain(a, b);
    chains_[std::max(a, b)][std::min(a, b)];
    known = known.empty() ? std::move(parts) : Chain{parallel({series(known), series(parts)})};
  }

  void look_at(std::size_t node) {
    if (node >= 2 && chains_[node].size() == 2) in_a_row_.push_back(node);
  }

  // The shorter chain moves, so that long ones are made in little more than their length.
  void join_at(std::size_t node) {
    const std::size_t a = chains_[node].begin()->first, b = chains_[node].rbegin()->first;
    Chain whole = std::move(chain(node, a)), rest = std::move(chain(node, b));
    if (whole.size() < rest.size()) swap(whole, rest);
    for (Relaxation& part : rest) whole.push_back(std::move(part));
    chains_[node].clear();
    chains_[a].erase(node);
    chains_[b].erase(node);
    connect(a, b, std::move(whole));
    look_at(a);
    look_at(b);
  }

  RelaxationGraph left() {
    RelaxationGraph graph;
    std::map<std::size_t, int> names{{0, 0}, {1, 1}};
    const auto name = [&](std::size_t node) {
      return names.try_emplace(node, static_cast<int>(names.size())).first->second;
    };
    for (std::size_t node = 0; node < chains_.size(); ++node)
      for (const auto& [other, parts] : chains_[node])
        if (node < other) {
          const int from = name(node);
          graph.wires.push_back({from, name(other)});
          graph.edges.push_back(series(parts));
        }
    graph.nodes = names.size();
    return graph;
  }

  std::vector<std::map<std::size_t, Chain>> chains_;  // of each node, by the node at the other end
  std::vector<std::size_t> in_a_row_;                 // may have become others since
};

}  // namespace

RelaxationGraph condensed(const RelaxationGraph& graph) { return Condensing(graph).run(); }

}  // namespace vcrit
