// Networks of any wiring with values over many decades, which shrink towards few elements of value
// 1.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "network/expression.hpp"
#include "network/graph.hpp"

namespace vcrit::properties {

/// 10^-decades .. 10^decades in steps of 1/16 decade, so that equal values occur.
inline rc::Gen<double> magnitude(int decades) {
  return rc::gen::map(rc::gen::inRange(0, 32 * decades + 1),
                      [](int n) { return std::pow(10, (n % 2 == 0 ? n : -n - 1) / 32.0); });
}

/// One element, and how often what was laid down before is then joined, the last two parts at once.
struct Piece {
  ElementKind kind = ElementKind::spring;
  double coefficient = 1, time = 1;
  int joins = 0;
  bool in_series = false;
};

/// Any list of pieces is a tree: what is left unjoined in the end is joined then.
using Pieces = std::vector<Piece>;

struct Wired {
  Network network;
  Values values;
};

inline rc::Gen<Pieces> pieces(int decades, int most) {
  const auto piece = rc::gen::build<Piece>(
      rc::gen::set(&Piece::kind, rc::gen::element(ElementKind::spring, ElementKind::damper,
                                                  ElementKind::maxwell)),
      rc::gen::set(&Piece::coefficient, magnitude(decades)),
      rc::gen::set(&Piece::time, magnitude(decades)),
      rc::gen::set(&Piece::joins, rc::gen::inRange(0, 3)), rc::gen::set(&Piece::in_series));
  return rc::gen::mapcat(rc::gen::inRange(1, most + 1), [piece](int count) {
    return rc::gen::container<Pieces>(static_cast<std::size_t>(count), piece);
  });
}

inline Network network_of(const Piece& piece, Values& values) {
  const std::string number = std::to_string(values.size());
  const Symbol coefficient{(piece.kind == ElementKind::damper ? "c" : "k") + number, 0};
  const Symbol time{"t" + number, 0};
  values[coefficient] = piece.coefficient;
  if (piece.kind == ElementKind::spring) return spring(coefficient);
  if (piece.kind == ElementKind::damper) return damper(coefficient);
  values[time] = piece.time;
  return maxwell(coefficient, time);
}

inline Network tree_of(const Pieces& pieces, Values& values) {
  std::vector<Network> stack;
  const auto join = [&](bool in_series) {
    Network last = std::move(stack.back());
    stack.pop_back();
    std::vector<Network> both{std::move(stack.back()), std::move(last)};
    stack.back() = in_series ? series(std::move(both)) : parallel(std::move(both));
  };
  for (const Piece& piece : pieces) {
    stack.push_back(network_of(piece, values));
    for (int i = 0; i < piece.joins && stack.size() > 1; ++i) join(piece.in_series);
  }
  while (stack.size() > 1) join(pieces.front().in_series);
  return std::move(stack.front());
}

inline Wired tree_of(const Pieces& pieces) {
  Wired wired;
  wired.network = tree_of(pieces, wired.values);
  return wired;
}

/// Edges between any two of a few nodes, each a small tree.
struct Edge {
  int from = 0, way = 0;
  Pieces pieces;
};
using Edges = std::vector<Edge>;

inline rc::Gen<Edges> edges(int decades, int most) {
  const auto edge = rc::gen::build<Edge>(rc::gen::set(&Edge::from, rc::gen::inRange(0, 6)),
                                         rc::gen::set(&Edge::way, rc::gen::inRange(0, 5)),
                                         rc::gen::set(&Edge::pieces, pieces(decades, 2)));
  return rc::gen::mapcat(rc::gen::inRange(1, most + 1), [edge](int count) {
    return rc::gen::container<Edges>(static_cast<std::size_t>(count), edge);
  });
}

/// Of six nodes, terminals among them, what carries load; a first edge joins the terminals.
inline Wired graph_of(const Edges& edges) {
  Wired wired;
  Graph graph{{"a", "b", "1", "2", "3", "4"}, {}, {{0, 1}}};
  graph.parts.push_back(tree_of(edges.front().pieces, wired.values));
  for (const Edge& edge : edges) {
    graph.parts.push_back(tree_of(edge.pieces, wired.values));
    graph.wires.push_back({edge.from, (edge.from + 1 + edge.way) % 6});
  }
  wired.network = {load_carrying(graph)->graph};
  return wired;
}

inline void showValue(const Piece& piece, std::ostream& out) {
  const char* const kinds[] = {"spring", "damper", "maxwell"};
  out << kinds[static_cast<int>(piece.kind)] << ' ' << piece.coefficient;
  if (piece.kind == ElementKind::maxwell) out << ' ' << piece.time;
  if (piece.joins > 0) out << " join " << piece.joins;
  out << (piece.in_series ? " -" : " |");
}

inline void showValue(const Edge& edge, std::ostream& out) {
  out << edge.from << " to " << (edge.from + 1 + edge.way) % 6 << ": ";
  rc::show(edge.pieces, out);
}

}  // namespace vcrit::properties
