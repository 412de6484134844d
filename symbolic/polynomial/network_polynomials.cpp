#include "polynomial/network_polynomials.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <vector>

#include "base/errors.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"
#include "network/law.hpp"

namespace vcrit::symbolic {

namespace {

TermNumbers terms_in_parallel(const TermNumbers& a, const TermNumbers& b) {
  return {a.over * b.under + b.over * a.under, a.under * b.under};
}

TermNumbers terms_in_series(const TermNumbers& a, const TermNumbers& b) {
  return {a.over * b.over, a.over * b.under + b.over * a.under};
}

// With every edge a number, spanning trees and pairs of trees are counted by star-mesh elimination:
// the sum at each eliminated node is a pivot of the nodal matrix.
TermNumbers terms_of(const Graph& graph) {
  const std::size_t n = graph.nodes.size();
  std::vector<std::vector<double>> edge(n, std::vector<double>(n));
  TermNumbers result{0, 1};
  for (std::size_t i = 0; i < graph.parts.size(); ++i) {
    const auto from = static_cast<std::size_t>(graph.wires[i].from);
    const auto to = static_cast<std::size_t>(graph.wires[i].to);
    const TermNumbers part = term_numbers(graph.parts[i]);
    edge[from][to] = edge[to][from] = edge[from][to] + part.over / part.under;
    result.under *= part.under;
  }
  for (std::size_t node = n - 1; node >= 2; --node) {
    double total = 0;
    for (std::size_t i = 0; i < node; ++i) total += edge[node][i];
    result.under *= total;
    for (std::size_t i = 0; i < node; ++i)
      for (std::size_t j = 0; j < node; ++j)
        if (i != j) edge[i][j] += edge[node][i] * edge[node][j] / total;
  }
  return {std::round(edge[0][1] * result.under), std::round(result.under)};
}

template <class Value, class Of, class Combine>
Value folded(const std::vector<Network>& parts, const Of& of, const Combine& combine) {
  Value whole = of(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) whole = combine(whole, of(parts[i]));
  return whole;
}

// The minors of a graph's nodal matrix, its edges y0, y1, ...: row by row, each set of columns used
// so far with the sum of products that used it. Sets stay few where neighbours stand close.
class TreePolynomials {
 public:
  explicit TreePolynomials(const Graph& graph) : graph_(graph), ring_(names(graph.parts.size())) {
    minors_.emplace(std::vector<bool>(graph.nodes.size()), Polynomial(ring_, 1));
    for (std::size_t node = 2; node < graph.nodes.size(); ++node) add_row(node);
    std::vector<bool> inner(graph.nodes.size(), true);
    inner[0] = inner[1] = false;
    pairs_.emplace_back(minors_.at(inner));
    add_row(0);
    inner[0] = true;
    whole_.emplace_back(minors_.at(inner));
  }

  /// Sums of products of edges over spanning trees, and over pairs of trees.
  const Polynomial& whole() const { return whole_.front(); }
  const Polynomial& pairs() const { return pairs_.front(); }

 private:
  using Columns = std::vector<bool>;

  static std::vector<std::string> names(std::size_t count) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back("y" + std::to_string(i));
    return result;
  }

  /// The row's entries; node 1 is held and has no column.
  std::map<std::size_t, Polynomial> row(std::size_t node) const {
    std::map<std::size_t, Polynomial> entries;
    const Polynomial zero(ring_, 0);
    for (std::size_t i = 0; i < graph_.wires.size(); ++i) {
      const auto from = static_cast<std::size_t>(graph_.wires[i].from);
      const auto to = static_cast<std::size_t>(graph_.wires[i].to);
      if (from != node && to != node) continue;
      const Polynomial edge = Polynomial::variable(ring_, "y" + std::to_string(i));
      const std::size_t other = from == node ? to : from;
      entries.try_emplace(node, zero).first->second += edge;
      if (other != 1) entries.try_emplace(other, zero).first->second -= edge;
    }
    return entries;
  }

  void add_row(std::size_t node) {
    std::map<Columns, Polynomial> next;
    const auto entries = row(node);
    for (const auto& [used, minor] : minors_)
      for (const auto& [column, entry] : entries) {
        if (used[column]) continue;
        // Rows come as 2, 3, ..., 0; so do columns, of which the later ones decide the sign.
        const auto later = column == 0 ? 0
                                       : std::count(used.begin() + static_cast<long>(column) + 1,
                                                    used.end(), true) +
                                             (used[0] ? 1 : 0);
        Columns now = used;
        now[column] = true;
        Polynomial& sum = next.try_emplace(std::move(now), ring_, 0).first->second;
        if (later % 2 == 0)
          sum += minor * entry;
        else
          sum -= minor * entry;
      }
    minors_ = std::move(next);
  }

  const Graph& graph_;
  Ring ring_;
  std::map<Columns, Polynomial> minors_;
  std::vector<Polynomial> whole_, pairs_;
};

class Expansion {
 public:
  explicit Expansion(const Ring& ring)
      : ring_(ring), s_(Polynomial::variable(ring, own_name("s"))) {}

  using Value = PolynomialQuotient;

  PolynomialQuotient of(const Network& network) const {
    return std::visit([this](const auto& form) { return (*this)(form); }, network.form);
  }

  PolynomialQuotient of(const Symbol& symbol) const {
    return {Polynomial::variable(ring_, to_text(symbol)), Polynomial(ring_, 1)};
  }
  PolynomialQuotient constant(const TypedNumber& number) const {
    const GiNaC::numeric exact = exact_decimal(number.decimal);
    return {integer_polynomial(ring_, exact.numer()), integer_polynomial(ring_, exact.denom())};
  }
  static PolynomialQuotient plus(const PolynomialQuotient& a, const PolynomialQuotient& b) {
    return a + b;
  }
  static PolynomialQuotient times(const PolynomialQuotient& a, const PolynomialQuotient& b) {
    return a * b;
  }
  static PolynomialQuotient over(const PolynomialQuotient& a, const PolynomialQuotient& b) {
    return a * turned_over(b);
  }
  PolynomialQuotient times_s(const PolynomialQuotient& k) const { return {k.over * s_, k.under}; }
  PolynomialQuotient relaxing(const PolynomialQuotient& k, const PolynomialQuotient& tau) const {
    const Polynomial turn = tau.over * s_;
    return {k.over * turn, k.under * (tau.under + turn)};
  }

 private:
  PolynomialQuotient operator()(const Element& element) const { return law(element, *this); }
  PolynomialQuotient operator()(const Series& series) const {
    const auto join = [](const PolynomialQuotient& a,
                         const PolynomialQuotient& b) -> PolynomialQuotient {
      return {a.over * b.over, a.over * b.under + b.over * a.under};
    };
    return folded<PolynomialQuotient>(
        series.parts, [this](const Network& part) { return of(part); }, join);
  }
  PolynomialQuotient operator()(const Parallel& parallel) const {
    const auto join = [](const PolynomialQuotient& a,
                         const PolynomialQuotient& b) -> PolynomialQuotient {
      return {a.over * b.under + b.over * a.under, a.under * b.under};
    };
    return folded<PolynomialQuotient>(
        parallel.parts, [this](const Network& part) { return of(part); }, join);
  }
  PolynomialQuotient operator()(const Graph& graph) const {
    std::vector<PolynomialQuotient> edges;
    for (const Network& part : graph.parts) edges.push_back(of(part));
    const TreePolynomials trees(graph);
    return {put_in(trees.whole(), edges), put_in(trees.pairs(), edges)};
  }

  /// A sum of products of edges, times the denominators of all edges.
  Polynomial put_in(const Polynomial& trees, const std::vector<PolynomialQuotient>& edges) const {
    Polynomial sum(ring_, 0);
    for (std::size_t i = 0; i < trees.terms(); ++i) {
      const std::vector<unsigned long> taken = trees.exponents(i);
      Polynomial product(ring_, 1);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const Polynomial& factor = taken[e] > 0 ? edges[e].over : edges[e].under;
        if (!factor.is_one()) product *= factor;
      }
      sum += product;
    }
    return sum;
  }

  const Ring& ring_;
  Polynomial s_;
};

/// The algebra of an element's law, in numbers of terms.
struct ElementTerms {
  using Value = TermNumbers;
  static Value of(const Symbol&) { return {1, 1}; }
  static Value constant(const TypedNumber&) { return {1, 1}; }
  static Value plus(const Value& a, const Value& b) { return terms_in_parallel(a, b); }
  static Value times(const Value& a, const Value& b) {
    return {a.over * b.over, a.under * b.under};
  }
  static Value over(const Value& a, const Value& b) { return {a.over * b.under, a.under * b.over}; }
  static Value times_s(const Value& k) { return k; }
  static Value relaxing(const Value& k, const Value& tau) {
    return {k.over * tau.over, k.under * (tau.under + tau.over)};
  }
};

bool repeats_a_symbol(const Network& network) {
  if (!is_plain(network)) return true;  // as expressions may
  std::set<Symbol> seen;
  bool repeats = false;
  for_each_element(network, [&](const Element& element) {
    for_each_number(element, [&](const Symbol& symbol, NumberRole) {
      repeats = !seen.insert(symbol).second || repeats;
    });
  });
  return repeats;
}

}  // namespace

TermNumbers term_numbers(const Network& network) {
  if (const auto* element = std::get_if<Element>(&network.form))
    return law(*element, ElementTerms{});
  if (const auto* form = std::get_if<Series>(&network.form))
    return folded<TermNumbers>(form->parts, term_numbers, terms_in_series);
  if (const auto* form = std::get_if<Parallel>(&network.form))
    return folded<TermNumbers>(form->parts, term_numbers, terms_in_parallel);
  return terms_of(std::get<Graph>(network.form));
}

// The sum over spanning trees of a graph whose terminals, joined, leave no edge without load is
// irreducible or a product over its blocks, and prime to that over pairs of trees; what both may
// share are powers of s.
PolynomialQuotient stiffness(const Network& network, const Ring& ring) {
  const PolynomialQuotient k = Expansion(ring).of(network);
  if (repeats_a_symbol(network)) return cancelled(k);
  const unsigned long common =
      std::min(k.over.lowest_degree(own_name("s")), k.under.lowest_degree(own_name("s")));
  if (common == 0) return k;
  return {k.over.without_power(own_name("s"), common),
          k.under.without_power(own_name("s"), common)};
}

Polynomial integer_polynomial(const Ring& ring, const GiNaC::numeric& integer) {
  std::ostringstream digits;
  digits << integer;
  Polynomial result(ring, 0);
  result.add_term(digits.str(), std::vector<unsigned long>(ring.size()));
  return result;
}

}  // namespace vcrit::symbolic
