// The straight-line program, run with exact rational numbers against results known by hand.
#include <boost/rational.hpp>
#include <boost/test/unit_test.hpp>
#include <map>
#include <string>
#include <vector>

#include "network/expression.hpp"
#include "network/reduction.hpp"

BOOST_AUTO_TEST_SUITE(test_reduction)

using namespace vcrit;

namespace {

using Rational = boost::rational<long long>;

struct Exact {
  using Value = Rational;
  std::map<std::string, long long> values;
  Rational element(const Element& e) const { return values.at(e.coefficient.symbol().name); }
  static Rational parallel(Rational a, Rational b) { return a + b; }
  static Rational series(Rational a, Rational b) { return a * b / (a + b); }
  static Rational mesh(Rational a, Rational b, Rational total) { return a * b / total; }
};

Graph springs(int nodes, const std::vector<Wire>& wires) {
  Graph g;
  g.nodes.resize(static_cast<std::size_t>(nodes));
  for (std::size_t i = 0; i < wires.size(); ++i) {
    g.wires.push_back(wires[i]);
    g.parts.push_back(spring({"k" + std::to_string(i + 1)}));
  }
  return g;
}

}  // namespace

BOOST_AUTO_TEST_CASE(series_and_parallel) {
  const Network network =
      parallel({spring({"k1"}), series({spring({"k2"}), spring({"k3"}), spring({"k4"})})});
  Exact exact{{{"k1", 5}, {"k2", 2}, {"k3", 3}, {"k4", 6}}};
  BOOST_TEST(evaluate(reduce(network), exact) == Rational(6));  // 5 + 1/(1/2 + 1/3 + 1/6)
}

BOOST_AUTO_TEST_CASE(a_balanced_bridge_does_not_feel_its_middle) {
  const Graph bridge = springs(4, {{0, 2}, {0, 3}, {2, 1}, {3, 1}, {2, 3}});
  for (const long long middle : {1, 7, 1000}) {
    Exact exact{{{"k1", 2}, {"k2", 4}, {"k3", 2}, {"k4", 4}, {"k5", middle}}};
    BOOST_TEST(evaluate(reduce({bridge}), exact) == Rational(3));
  }
}

BOOST_AUTO_TEST_CASE(an_unbalanced_bridge) {
  // Five springs 1, 2, 3, 4, 5: spanning trees over spanning 2-forests, enumerated:
  // 155 = sum over trees, 74 = sum over 2-forests that separate the terminals.
  const Graph bridge = springs(4, {{0, 2}, {0, 3}, {2, 1}, {3, 1}, {2, 3}});
  Exact exact{{{"k1", 1}, {"k2", 2}, {"k3", 3}, {"k4", 4}, {"k5", 5}}};
  BOOST_TEST(evaluate(reduce({bridge}), exact) == Rational(155, 74));
}

BOOST_AUTO_TEST_CASE(the_complete_graph_of_equal_springs) {
  // Between two nodes of the complete graph of n nodes, unit springs add up to n/2.
  std::vector<Wire> wires;
  for (int i = 0; i < 6; ++i)
    for (int j = i + 1; j < 6; ++j) wires.push_back({i, j});
  Exact exact;
  for (std::size_t i = 1; i <= wires.size(); ++i) exact.values["k" + std::to_string(i)] = 1;
  BOOST_TEST(evaluate(reduce({springs(6, wires)}), exact) == Rational(3));
}

BOOST_AUTO_TEST_CASE(series_parallel_graphs_need_no_mesh_and_linear_size) {
  // A ladder of n rungs as a graph: 2 n edges reduce in 2 n elements and 2 n - 1 combinations.
  for (const int n : {5, 50, 500}) {
    std::vector<Wire> wires;
    for (int i = 0; i < n; ++i) {
      wires.push_back({i == 0 ? 0 : i + 1, i + 2});
      wires.push_back({i + 2, 1});
    }
    const Reduction reduction = reduce({springs(n + 2, wires)});
    BOOST_TEST(reduction.steps.size() == static_cast<std::size_t>(4 * n - 1));
    for (const Step& step : reduction.steps) BOOST_TEST((step.kind != Step::Kind::mesh));
  }
}

BOOST_AUTO_TEST_SUITE_END()
