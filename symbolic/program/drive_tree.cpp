#include "program/drive_tree.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"

namespace vcrit::symbolic {

namespace {

// Twice the length of a contact's graph: there is nothing else to take beyond.
constexpr std::size_t longest_drive_graph = 3000;

struct DriveEdge {
  int from, to;
  DrivePair pair;
};
using DriveEdges = std::vector<DriveEdge>;

/// As in spanning_trees.cpp, on numbers of any sign. Pairs of a graph may have no common factor
/// dropped or added: sums with and without an edge are added up.
class DriveGraphWriter {
 public:
  DriveGraphWriter(Program& program, PairWriter& writer)
      : program_(program), writer_(writer), limit_(program.nodes().size() + longest_drive_graph) {}

  DrivePair between_terminals(DriveEdges edges) {
    if (program_.nodes().size() > limit_)
      throw ModelError(
          fmt::format("the drive's graph takes more than {} steps of code beside its masses",
                      longest_drive_graph),
          "vcrit eval needs no code; a drive whose graph has fewer edges between its inner nodes "
          "has some");
    std::optional<DrivePair> outside;  // in every spanning tree
    while (drop_dead_end(edges, outside) || join_parallel(edges) || join_series(edges)) {
    }
    const DrivePair whole = edges.size() == 1 ? edges.front().pair : split(std::move(edges));
    return outside ? writer_.times(whole, *outside) : whole;
  }

 private:
  DrivePair split(DriveEdges edges) {
    const auto across = std::find_if(edges.begin(), edges.end(),
                                     [](const DriveEdge& e) { return e.from + e.to == 1; });
    if (across != edges.end()) {
      const DrivePair direct = across->pair;
      edges.erase(across);
      return writer_.parallel(direct, between_terminals(std::move(edges)));
    }
    const auto inner = std::find_if(edges.begin(), edges.end(),
                                    [](const DriveEdge& e) { return e.from > 1 && e.to > 1; });
    const auto chosen = inner == edges.end() ? edges.begin() : inner;
    const DriveEdge edge = *chosen;
    edges.erase(chosen);
    const DrivePair without = between_terminals(edges);
    return writer_.by_edge(edge.pair, without, between_terminals(contracted(edges, edge)));
  }

  static std::map<int, std::vector<std::size_t>> edges_at_inner_nodes(const DriveEdges& edges) {
    std::map<int, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (const int node : {edges[i].from, edges[i].to})
        if (node > 1) at[node].push_back(i);
    return at;
  }

  static void erase(DriveEdges& edges, std::size_t i) {
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
  }

  bool drop_dead_end(DriveEdges& edges, std::optional<DrivePair>& outside) {
    for (const auto& [node, at] : edges_at_inner_nodes(edges)) {
      if (at.size() != 1) continue;
      const DrivePair& end = edges[at[0]].pair;
      outside = outside ? writer_.times(*outside, end) : end;
      erase(edges, at[0]);
      return true;
    }
    return false;
  }

  bool join_parallel(DriveEdges& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size(); ++j) {
        if (std::minmax(edges[i].from, edges[i].to) != std::minmax(edges[j].from, edges[j].to))
          continue;
        edges[i].pair = writer_.parallel(edges[i].pair, edges[j].pair);
        erase(edges, j);
        return true;
      }
    return false;
  }

  bool join_series(DriveEdges& edges) {
    for (const auto& [node, at] : edges_at_inner_nodes(edges)) {
      if (at.size() != 2) continue;
      DriveEdge& first = edges[at[0]];
      const DriveEdge& second = edges[at[1]];
      const auto other_end = [node = node](const DriveEdge& e) {
        return e.from == node ? e.to : e.from;
      };
      first = {other_end(first), other_end(second), writer_.series(first.pair, second.pair)};
      erase(edges, at[1]);
      return true;
    }
    return false;
  }

  static DriveEdges contracted(DriveEdges edges, const DriveEdge& joined) {
    const auto [kept, gone] = std::minmax(joined.from, joined.to);
    for (DriveEdge& e : edges)
      for (int* node : {&e.from, &e.to})
        if (*node == gone) *node = kept;
    return edges;
  }

  Program& program_;
  PairWriter& writer_;
  std::size_t limit_;
};

class DriveWalk {
 public:
  DriveWalk(Program& program, PairWriter& writer) : program_(program), writer_(writer) {}

  DrivePair write(const Network& network) {
    if (!has_masses(network)) return writer_.massless(network);
    if (const auto* e = std::get_if<Element>(&network.form)) return writer_.mass(*e);
    if (const auto* s = std::get_if<Series>(&network.form))
      return fold(s->parts, &PairWriter::series,
                  [](auto parts) { return series(std::move(parts)); });
    if (const auto* p = std::get_if<Parallel>(&network.form))
      return fold(p->parts, &PairWriter::parallel,
                  [](auto parts) { return parallel(std::move(parts)); });
    return graph(std::get<Graph>(network.form));
  }

 private:
  using Combine = DrivePair (PairWriter::*)(DrivePair, DrivePair);

  /// What has no mass comes first, as one stiffness, then single masses: neither a series nor a
  /// parallel combination depends on the order, and a spring beside a mass is an exact difference.
  template <class Together>
  DrivePair fold(const std::vector<Network>& parts, Combine combine, const Together& together) {
    std::vector<Network> massless;
    std::vector<const Network*> masses, others;
    for (const Network& part : parts) {
      if (!has_masses(part))
        massless.push_back(part);
      else
        (std::holds_alternative<Element>(part.form) ? masses : others).push_back(&part);
    }
    std::optional<DrivePair> whole;
    if (!massless.empty()) whole = writer_.massless(together(std::move(massless)));
    masses.insert(masses.end(), others.begin(), others.end());
    for (const Network* part : masses) {
      const DrivePair next = write(*part);
      whole = whole ? (writer_.*combine)(*whole, next) : next;
    }
    ensure(whole.has_value(), "a combination has parts");
    return *whole;
  }

  DrivePair graph(const Graph& graph) {
    DriveEdges edges;
    for (std::size_t i = 0; i < graph.parts.size(); ++i)
      edges.push_back({graph.wires[i].from, graph.wires[i].to, write(graph.parts[i])});
    return DriveGraphWriter(program_, writer_).between_terminals(std::move(edges));
  }

  Program& program_;
  PairWriter& writer_;
};

}  // namespace

DrivePair drive_pair(Program& program, PairWriter& writer, const Network& network) {
  return DriveWalk(program, writer).write(network);
}

}  // namespace vcrit::symbolic
