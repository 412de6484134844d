#include "scaling/families.hpp"

#include <fmt/core.h>

#include "network/graph.hpp"

namespace vcrit::scaling {

namespace {

Network element(bool is_spring, int number) {
  return is_spring ? spring({"k" + std::to_string(number)})
                   : damper({"c" + std::to_string(number)});
}

class Wires {
 public:
  Wiring all;

  void place(const Network& network, std::size_t a, std::size_t b) {
    std::visit([&](const auto& form) { place(form, a, b); }, network.form);
  }

 private:
  void place(const Element& e, std::size_t a, std::size_t b) {
    const std::string k = to_text(e.coefficient);
    if (e.kind == ElementKind::spring) return all.edges.push_back({a, b, k});
    if (e.kind == ElementKind::damper) return all.edges.push_back({a, b, k + "*s"});
    const std::size_t inner = all.nodes++;
    all.edges.push_back({a, inner, k});
    all.edges.push_back({inner, b, k + "*" + to_text(e.second) + "*s"});
  }
  void place(const Series& series, std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < series.parts.size(); ++i) {
      const std::size_t to = i + 1 == series.parts.size() ? b : all.nodes++;
      place(series.parts[i], a, to);
      a = to;
    }
  }
  void place(const Parallel& parallel, std::size_t a, std::size_t b) {
    for (const Network& part : parallel.parts) place(part, a, b);
  }
  void place(const Graph& graph, std::size_t a, std::size_t b) {
    std::vector<std::size_t> names{a, b};
    while (names.size() < graph.nodes.size()) names.push_back(all.nodes++);
    for (std::size_t i = 0; i < graph.parts.size(); ++i)
      place(graph.parts[i], names[static_cast<std::size_t>(graph.wires[i].from)],
            names[static_cast<std::size_t>(graph.wires[i].to)]);
  }
};

}  // namespace

ScalingCase ladder(int elements) {
  Network whole = element(elements % 2 == 1, elements);
  for (int i = elements - 1; i > 0; --i)
    whole = i % 2 == 1 ? series({element(true, i), whole}) : parallel({element(false, i), whole});
  return {fmt::format("ladder-{}", elements), whole};
}

ScalingCase prony(int branches) {
  std::vector<Network> parts{spring({"k0"})};
  for (int i = 1; i <= branches; ++i)
    parts.push_back(maxwell({"k" + std::to_string(i)}, {"tau" + std::to_string(i)}));
  return {fmt::format("Prony-{}", branches), parallel(parts)};
}

ScalingCase bridge() {
  const Graph graph{
      {"a", "b", "1", "2"},
      {element(true, 1), element(false, 1), element(true, 2), element(false, 2), element(true, 3)},
      {{0, 2}, {0, 3}, {2, 3}, {2, 1}, {3, 1}}};
  return {"bridge", {graph}};
}

ScalingCase grid(int n) {
  Graph graph;
  graph.nodes = {"a", "b"};
  std::vector<int> names;
  for (int i = 0; i < n * n; ++i) {
    const bool first = i == 0, last = i + 1 == n * n;
    names.push_back(first ? 0 : last ? 1 : static_cast<int>(graph.nodes.size()));
    if (!first && !last) graph.nodes.push_back(std::to_string(i));
  }
  const auto add = [&](int from, int to) {
    const int number = static_cast<int>(graph.parts.size()) + 1;
    graph.parts.push_back(element(number % 2 == 1, number));
    graph.wires.push_back(
        {names[static_cast<std::size_t>(from)], names[static_cast<std::size_t>(to)]});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (j + 1 < n) add(i * n + j, i * n + j + 1);
      if (i + 1 < n) add(i * n + j, i * n + j + n);
    }
  return {fmt::format("{0}x{0} grid", n), {graph}};
}

Wiring wiring(const Network& network) {
  Wires wires;
  wires.place(network, 0, 1);
  return wires.all;
}

}  // namespace vcrit::scaling
