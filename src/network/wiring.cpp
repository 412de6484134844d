#include "network/wiring.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"

namespace vcrit {

namespace {

struct Wiring {
  static void check(const std::vector<Network>& parts) {
    for (const Network& part : parts) check_wiring(part);
  }

  void operator()(const Element&) const {}
  void operator()(const Series& series) const { check_parts(series.parts, "series"); }
  void operator()(const Parallel& parallel) const { check_parts(parallel.parts, "parallel"); }
  void operator()(const Graph& graph) const {
    const std::size_t nodes = graph.nodes.size(), wires = graph.wires.size();
    if (nodes < 2 || wires == 0 || graph.parts.size() != wires)
      throw InputError(argument("network"),
                       fmt::format("a graph of {} nodes and {} wires with {} parts", nodes, wires,
                                   graph.parts.size()),
                       "two nodes or more, the terminals first, and a part for each wire");
    const auto count = static_cast<int>(nodes);
    for (const auto& [from, to] : graph.wires)
      if (from < 0 || to < 0 || from >= count || to >= count || from == to)
        throw InputError(argument("network"), fmt::format("a wire from {} to {}", from, to),
                         fmt::format("two different nodes of the graph, from 0 to {}", count - 1));
    check(graph.parts);
  }

 private:
  static void check_parts(const std::vector<Network>& parts, const char* combination) {
    if (parts.empty())
      throw InputError(argument("network"), fmt::format("{} without parts", combination),
                       "one part or more");
    check(parts);
  }
};

}  // namespace

double value_of(const Values& values, const Symbol& symbol) {
  const auto found = values.find(symbol);
  if (found != values.end()) return found->second;
  throw InputError(argument("values"), fmt::format("none for {}", to_text(symbol)),
                   "a value for each symbol of the network");
}

void check_wiring(const Network& network) { std::visit(Wiring{}, network.form); }

}  // namespace vcrit
