#include "network/wiring.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"

namespace vcrit {

namespace {

[[noreturn]] void refuse_sizes(const Graph& graph) {
  throw InputError(argument("network"),
                   fmt::format("a graph of {} nodes and {} wires with {} parts", graph.nodes.size(),
                               graph.wires.size(), graph.parts.size()),
                   "two nodes or more, the terminals first, and a part for each wire");
}

[[noreturn]] void refuse_wire(const Graph& graph, const Wire& wire) {
  throw InputError(
      argument("network"), fmt::format("a wire from {} to {}", wire.from, wire.to),
      fmt::format("two different nodes of the graph, from 0 to {}", graph.nodes.size() - 1));
}

struct Wiring {
  static void check(const std::vector<Network>& parts) {
    for (const Network& part : parts) check_wiring(part);
  }

  void operator()(const Element&) const {}
  void operator()(const Series& series) const { check_parts(series.parts, "series"); }
  void operator()(const Parallel& parallel) const { check_parts(parallel.parts, "parallel"); }
  void operator()(const Graph& graph) const {
    if (graph.wires.empty()) refuse_sizes(graph);
    check_wires(graph);
    for (const Wire& wire : graph.wires)
      if (wire.from == wire.to) refuse_wire(graph, wire);
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
  if (const double* const found = values.find(symbol)) return *found;
  throw InputError(argument("values"), fmt::format("none for {}", to_text(symbol)),
                   "a value for each symbol of the network");
}

void check_wires(const Graph& graph) {
  if (graph.nodes.size() < 2 || graph.parts.size() != graph.wires.size()) refuse_sizes(graph);
  const auto count = static_cast<int>(graph.nodes.size());
  for (const Wire& wire : graph.wires)
    if (wire.from < 0 || wire.to < 0 || wire.from >= count || wire.to >= count)
      refuse_wire(graph, wire);
}

void check_wiring(const Network& network) { std::visit(Wiring{}, network.form); }

}  // namespace vcrit
