#include "network/graph.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <set>
#include <utility>

#include "network/law.hpp"
#include "network/wiring.hpp"

namespace vcrit {

namespace {

using EdgeIndex = boost::property<boost::edge_index_t, std::size_t>;
using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                         boost::no_property, EdgeIndex>;

// An edge carries load if it lies on a simple path between the terminals: if it shares a
// biconnected component with an edge added from terminal to terminal. Every edge has a vertex of
// its own in its middle, since the algorithm knows one edge between two vertices only.
std::vector<bool> carries_load(const Graph& graph) {
  const std::size_t nodes = graph.nodes.size(), closing = graph.wires.size();
  BoostGraph g(nodes + closing);
  boost::add_edge(0, 1, EdgeIndex(closing), g);
  const auto loops = [](const Wire& wire) { return wire.from == wire.to; };
  for (std::size_t i = 0; i < closing; ++i) {
    if (loops(graph.wires[i])) continue;
    boost::add_edge(static_cast<std::size_t>(graph.wires[i].from), nodes + i, EdgeIndex(i), g);
    boost::add_edge(static_cast<std::size_t>(graph.wires[i].to), nodes + i,
                    EdgeIndex(closing + 1 + i), g);
  }
  std::vector<std::size_t> component(2 * closing + 1);
  boost::biconnected_components(
      g, boost::make_iterator_property_map(component.begin(), boost::get(boost::edge_index, g)));
  std::vector<bool> carries(closing);
  for (std::size_t i = 0; i < closing; ++i)
    carries[i] = component[i] == component[closing] && !loops(graph.wires[i]);
  return carries;
}

std::optional<Network> changed_parts(const Series& series, const NewElement& element_of) {
  std::vector<Network> left;
  left.reserve(series.parts.size());
  for (const Network& part : series.parts) {
    auto kept = with_elements(part, element_of);
    if (!kept) return std::nullopt;
    left.push_back(std::move(*kept));
  }
  return vcrit::series(std::move(left));
}

std::optional<Network> changed_parts(const Parallel& parallel, const NewElement& element_of) {
  std::vector<Network> left;
  left.reserve(parallel.parts.size());
  for (const Network& part : parallel.parts)
    if (auto kept = with_elements(part, element_of)) left.push_back(std::move(*kept));
  if (left.empty()) return std::nullopt;
  return vcrit::parallel(std::move(left));
}

std::optional<Network> changed_parts(const Graph& graph, const NewElement& element_of) {
  check_wires(graph);
  Graph left{graph.nodes, {}, {}};
  left.parts.reserve(graph.parts.size());
  left.wires.reserve(graph.wires.size());
  for (std::size_t i = 0; i < graph.parts.size(); ++i)
    if (auto kept = with_elements(graph.parts[i], element_of)) {
      left.parts.push_back(std::move(*kept));
      left.wires.push_back(graph.wires[i]);
    }
  // Where no edge has gone, all others carry load as before.
  if (left.wires.size() == graph.wires.size()) return Network{std::move(left)};
  auto loaded = load_carrying(std::move(left));
  if (!loaded) return std::nullopt;
  return Network{std::move(loaded->graph)};
}

std::optional<Network> changed_parts(const Element& element, const NewElement& element_of) {
  if (auto other = element_of(element)) return Network{std::move(*other)};
  return std::nullopt;
}

}  // namespace

std::optional<LoadedGraph> load_carrying(Graph graph) {
  check_wires(graph);
  const std::vector<bool> carries = carries_load(graph);
  std::vector<std::string> names = std::move(graph.nodes);
  LoadedGraph loaded{{{std::move(names[0]), std::move(names[1])}, {}, {}}, {}};
  std::vector<int> renamed(names.size(), -1);
  renamed[0] = 0;
  renamed[1] = 1;
  const auto keep_node = [&](int node) {
    int& name = renamed[static_cast<std::size_t>(node)];
    if (name < 0) {
      name = static_cast<int>(loaded.graph.nodes.size());
      loaded.graph.nodes.push_back(std::move(names[static_cast<std::size_t>(node)]));
    }
    return name;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < graph.wires.size(); ++i) {
    if (!carries[i]) {
      loaded.left_out.push_back(i);
      continue;
    }
    if (kept < i) graph.parts[kept] = std::move(graph.parts[i]);
    const int from = keep_node(graph.wires[i].from);
    graph.wires[kept++] = {from, keep_node(graph.wires[i].to)};
  }
  if (kept == 0) return std::nullopt;
  graph.parts.resize(kept);
  graph.wires.resize(kept);
  loaded.graph.parts = std::move(graph.parts);
  loaded.graph.wires = std::move(graph.wires);
  return loaded;
}

std::optional<Network> with_elements(const Network& network, const NewElement& element_of) {
  return std::visit([&](const auto& form) { return changed_parts(form, element_of); },
                    network.form);
}

std::optional<Network> without(const Network& network,
                               const std::function<bool(const Element&)>& absent) {
  return with_elements(network, [&](const Element& e) -> std::optional<Element> {
    if (absent(e)) return std::nullopt;
    return e;
  });
}

std::optional<Network> springs_alone(const Network& network) {
  return with_elements(network, [](const Element& element) { return at_rest(element); });
}

}  // namespace vcrit
