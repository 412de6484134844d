#include "program/spanning_trees.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/errors.hpp"

namespace vcrit::symbolic {

namespace {

// Beyond this star-mesh elimination is the shorter program.
constexpr std::size_t most_nodes = 1500;

/// T = sum over the spanning trees of the edges t or q that each of them holds or leaves out, Q the
/// same with the terminals joined; no common factor may be dropped, as the two are added up.
/// Errors are in roundings of the number's own absolute value.
struct Pair {
  ComplexNode t, q;
  double t_error = 0, q_error = 0;
  ExponentRange t_range, q_range;
};

struct Edge {
  int from, to;
  Pair pair;
};

class TooLong {};

class TreeWriter {
 public:
  TreeWriter(Program& program, Zeros zeros, std::size_t limit)
      : program_(program), zeros_(zeros), limit_(limit) {}

  /// Edges may be 0 where numbers have a range that holds a zero.
  Pair whole(std::vector<Edge> edges) {
    while (join_parallel(edges) || join_series(edges, Sums::of_all_edges)) {
    }
    if (edges.size() > 1 && edges.front().pair.t.coefficients.empty()) tie_loose_parts(edges);
    return between_terminals(std::move(edges));
  }

 private:
  Pair between_terminals(std::vector<Edge> edges) {
    if (program_.nodes().size() > limit_) throw TooLong();
    const ComplexNode unity = this->unity(edges);
    Pair outside{unity, unity, 0, 0, {}, {}};  // factors of both sums
    reduce(edges, outside);
    const auto across =
        std::find_if(edges.begin(), edges.end(), [](const Edge& e) { return e.from + e.to == 1; });
    if (across != edges.end() && edges.size() > 1) {
      const Pair direct = across->pair;
      edges.erase(across);
      return times(parallel(direct, between_terminals(std::move(edges))), outside);
    }
    if (edges.size() == 1) return times(edges.front().pair, outside);
    const std::size_t chosen = inner_edge(edges);
    const Edge e = edges[chosen];
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(chosen));
    const Pair without = between_terminals(edges);
    const Pair joined = between_terminals(contracted(edges, e));
    const Term left_t{e.pair.q, without.t, e.pair.q_error + without.t_error,
                      e.pair.q_range + without.t_range},
        right_t{e.pair.t, joined.t, e.pair.t_error + joined.t_error,
                e.pair.t_range + joined.t_range},
        left_q{e.pair.q, without.q, e.pair.q_error + without.q_error,
               e.pair.q_range + without.q_range},
        right_q{e.pair.t, joined.q, e.pair.t_error + joined.q_error,
                e.pair.t_range + joined.q_range};
    Pair whole;
    add(left_t, right_t, whole.t, whole.t_error, whole.t_range);
    add(left_q, right_q, whole.q, whole.q_error, whole.q_range);
    return times(whole, outside);
  }

  /// Those of a graph without one of its edges are 0 where that loosens a part; those of the whole
  /// graph must not be.
  enum class Sums { of_all_edges, of_some_edges };

  /// A product of two complex numbers with its error.
  struct Term {
    ComplexNode a, b;
    double error;
    ExponentRange range;
  };

  ComplexNode unity(const std::vector<Edge>& edges) {
    const NodeId one = program_.constant(1);
    if (!edges.front().pair.t.coefficients.empty()) return polynomial({one});
    return {one, program_.constant(0)};
  }

  // Both sums of spanning trees are the same multiple of two stiffnesses that add up: they lie in
  // one quadrant, |a| + |b| <= sqrt(2) |a + b|.
  void add(const Term& a, const Term& b, ComplexNode& sum, double& error, ExponentRange& range) {
    const ComplexSum whole = sum_of_products(program_, {{a.a, a.b}, {b.a, b.b}});
    sum = whole.value;
    error = 1.4143 * std::max(a.error, b.error) + 2 * whole.roundings;
    range = sum_range(a.range, b.range, zeros_);
  }

  ComplexNode product(const ComplexNode& a, const ComplexNode& b, double& error) {
    const ComplexSum whole = sum_of_products(program_, {{a, b}});
    error += 1.4143 * whole.roundings;
    return whole.value;
  }

  Pair parallel(const Pair& a, const Pair& b) {
    Pair whole;
    add({a.t, b.q, a.t_error + b.q_error, a.t_range + b.q_range},
        {b.t, a.q, b.t_error + a.q_error, b.t_range + a.q_range}, whole.t, whole.t_error,
        whole.t_range);
    whole.q_error = a.q_error + b.q_error;
    whole.q = product(a.q, b.q, whole.q_error);
    whole.q_range = a.q_range + b.q_range;
    return whole;
  }

  /// Compliances Q/T add up.
  Pair series(const Pair& a, const Pair& b) {
    return exchanged(parallel(exchanged(a), exchanged(b)));
  }
  static Pair exchanged(const Pair& a) {
    return {a.q, a.t, a.q_error, a.t_error, a.q_range, a.t_range};
  }

  Pair times(const Pair& a, const Pair& factor) {
    if (is_one(program_, factor.t)) return a;
    Pair whole = a;
    whole.t_error += factor.t_error;
    whole.q_error += factor.t_error;
    whole.t = product(a.t, factor.t, whole.t_error);
    whole.q = product(a.q, factor.t, whole.q_error);
    whole.t_range = a.t_range + factor.t_range;
    whole.q_range = a.q_range + factor.t_range;
    return whole;
  }

  void multiply_outside(Pair& outside, const ComplexNode& factor, double error,
                        ExponentRange range) {
    outside.t_error += error;
    outside.t = product(outside.t, factor, outside.t_error);
    outside.t_range = outside.t_range + range;
  }

  /// Dead ends, parallel edges and nodes of two edges, until there are none.
  void reduce(std::vector<Edge>& edges, Pair& outside) {
    while (drop_dead_end(edges, outside) || join_parallel(edges) ||
           join_series(edges, Sums::of_some_edges)) {
    }
  }

  static std::map<int, std::vector<std::size_t>> edges_at_inner_nodes(
      const std::vector<Edge>& edges) {
    std::map<int, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (const int node : {edges[i].from, edges[i].to})
        if (node > 1) at[node].push_back(i);
    return at;
  }

  // In every spanning tree.
  bool drop_dead_end(std::vector<Edge>& edges, Pair& outside) {
    for (const auto& [node, at] : edges_at_inner_nodes(edges)) {
      if (at.size() != 1) continue;
      const Pair& pair = edges[at[0]].pair;
      multiply_outside(outside, pair.t, pair.t_error, pair.t_range);
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(at[0]));
      return true;
    }
    return false;
  }

  bool join_parallel(std::vector<Edge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size(); ++j) {
        if (std::minmax(edges[i].from, edges[i].to) != std::minmax(edges[j].from, edges[j].to))
          continue;
        edges[i].pair = parallel(edges[i].pair, edges[j].pair);
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(j));
        return true;
      }
    return false;
  }

  bool join_series(std::vector<Edge>& edges, Sums sums) {
    for (const auto& [node, at] : edges_at_inner_nodes(edges)) {
      if (at.size() != 2) continue;
      Edge& first = edges[at[0]];
      const Edge& second = edges[at[1]];
      const auto other_end = [node = node](const Edge& e) {
        return e.from == node ? e.to : e.from;
      };
      first = {other_end(first), other_end(second), series(first.pair, second.pair)};
      ComplexNode& q = first.pair.q;
      if (sums == Sums::of_all_edges && q.coefficients.empty()) {
        q.re = program_.nonzero(q.re, q.im);
        first.pair.q_range = with_one(first.pair.q_range, zeros_);
      }
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(at[1]));
      return true;
    }
    return false;
  }

  /// Nodes as letters, inner ones in the order in which they come.
  static std::string wiring(const std::vector<Edge>& edges) {
    std::map<int, char> letters{{0, 'a'}, {1, 'b'}};
    std::string text;
    for (const Edge& e : edges)
      for (const int node : {e.from, e.to}) {
        if (letters.size() == Program::most_nodes && !letters.contains(node)) throw TooLong();
        text += letters.try_emplace(node, static_cast<char>('a' + letters.size())).first->second;
      }
    return text;
  }

  void tie_loose_parts(std::vector<Edge>& edges) {
    if (edges.size() > Program::most_edges) throw TooLong();
    const std::string wires = wiring(edges);
    std::vector<std::pair<NodeId, NodeId>> stiffnesses;
    for (const Edge& e : edges) stiffnesses.emplace_back(e.pair.t.re, e.pair.t.im);
    const NodeId gaps = program_.gaps(stiffnesses);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ComplexNode& t = edges[i].pair.t;
      const NodeId tie = program_.tie(gaps, i, wires);
      // 1 or i: what is real or imaginary stays so.
      const bool is_imaginary = program_.is_constant(t.re, 0);
      t.re = program_.tied(t.re, tie, is_imaginary ? 0 : 1);
      t.im = program_.tied(t.im, tie, is_imaginary ? 1 : 0);
      edges[i].pair.t_range = with_one(edges[i].pair.t_range, zeros_);
    }
  }

  /// Between inner nodes if there is one; after reduce() no edge's loss disconnects the rest.
  static std::size_t inner_edge(const std::vector<Edge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (edges[i].from > 1 && edges[i].to > 1) return i;
    return 0;
  }

  /// No edge becomes a loop: none was parallel to the joined one.
  static std::vector<Edge> contracted(std::vector<Edge> edges, const Edge& joined) {
    const auto [kept, gone] = std::minmax(joined.from, joined.to);
    for (Edge& e : edges)
      for (int* node : {&e.from, &e.to})
        if (*node == gone) *node = kept;
    return edges;
  }

  Program& program_;
  Zeros zeros_;
  std::size_t limit_;
};

}  // namespace

std::optional<Stiffness> by_spanning_trees(Program& program, const Graph& graph,
                                           const std::vector<Stiffness>& parts, Zeros zeros) {
  std::vector<Edge> edges;
  Stiffness whole;
  whole.elements = parts.front().elements;
  whole.count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    edges.push_back({graph.wires[i].from,
                     graph.wires[i].to,
                     {parts[i].t, parts[i].q, 0, 0, parts[i].t_range, parts[i].q_range}});
    whole.elements = {std::min(whole.elements.low, parts[i].elements.low),
                      std::max(whole.elements.high, parts[i].elements.high)};
    whole.count += parts[i].count;
    whole.path = std::max(whole.path, parts[i].path);
  }
  const Program before = program;
  try {
    const Pair pair = TreeWriter(program, zeros, program.nodes().size() + most_nodes).whole(edges);
    whole.t = pair.t;
    whole.q = pair.q;
    whole.range = network_range(whole.elements, whole.count);
    whole.t_range = both(pair.t_range, whole.range + pair.q_range);
    whole.q_range = quotient_range(whole.t_range, whole.range, pair.q_range, zeros);
    whole.path += static_cast<int>(std::ceil(pair.t_error + pair.q_error));
    return whole;
  } catch (const TooLong&) {
    program = before;
    return std::nullopt;
  }
}

}  // namespace vcrit::symbolic
