// What carries load in a graph, and networks with elements left out.
#include <boost/test/unit_test.hpp>
#include <set>
#include <string>
#include <vector>

#include "network/graph.hpp"

BOOST_AUTO_TEST_SUITE(test_graph)

using namespace vcrit;

namespace {

// Nodes a, b are the terminals, the rest as they come.
Graph graph(int nodes, const std::vector<Wire>& wires) {
  Graph g;
  for (int n = 0; n < nodes; ++n) g.nodes.push_back(std::string(1, static_cast<char>('a' + n)));
  for (std::size_t i = 0; i < wires.size(); ++i) {
    g.wires.push_back(wires[i]);
    g.parts.push_back(spring({"k" + std::to_string(i)}));
  }
  return g;
}

using Indices = std::vector<std::size_t>;

}  // namespace

BOOST_AUTO_TEST_CASE(every_edge_of_a_bridge_carries_load) {
  const auto loaded = load_carrying(graph(4, {{0, 2}, {0, 3}, {2, 3}, {2, 1}, {3, 1}}));
  BOOST_REQUIRE(loaded);
  BOOST_TEST(loaded->left_out.empty());
  BOOST_TEST(loaded->graph.wires.size() == 5);
}

BOOST_AUTO_TEST_CASE(dangling_edges_trees_and_loops_do_not) {
  // 1: a branch of two edges; 3, 4: a loop hanging on node c by one node; 5: an edge to itself.
  const auto loaded =
      load_carrying(graph(7, {{0, 2}, {2, 1}, {2, 3}, {2, 4}, {4, 5}, {5, 2}, {2, 2}, {3, 6}}));
  BOOST_REQUIRE(loaded);
  BOOST_CHECK((loaded->left_out == Indices{2, 3, 4, 5, 6, 7}));
  BOOST_CHECK((loaded->graph.nodes == std::vector<std::string>{"a", "b", "c"}));
}

// Two edges between the same nodes, beside a branch that dangles: a straight one from terminal to
// terminal, and two at an inner node.
BOOST_AUTO_TEST_CASE(edges_side_by_side_carry_load) {
  const auto straight = load_carrying(graph(3, {{0, 1}, {1, 2}}));
  BOOST_REQUIRE(straight);
  BOOST_CHECK((straight->left_out == Indices{1}));
  const auto twice = load_carrying(graph(4, {{0, 3}, {0, 2}, {2, 1}, {1, 2}, {2, 1}}));
  BOOST_REQUIRE(twice);
  BOOST_CHECK((twice->left_out == Indices{0}));
}

BOOST_AUTO_TEST_CASE(unconnected_terminals_are_told) {
  BOOST_TEST(!load_carrying(graph(4, {{0, 2}, {1, 3}})).has_value());
  BOOST_TEST(!load_carrying(graph(3, {{0, 2}})).has_value());
}

BOOST_AUTO_TEST_CASE(a_missing_element_is_an_open_gap) {
  const Network k0 = spring({"k0"}), k1 = spring({"k1"}), c1 = damper({"c1"});
  const auto without_names = [](const Network& network, const std::set<std::string>& names) {
    return without(network,
                   [&](const Element& e) { return names.contains(e.coefficient.symbol().name); });
  };
  const Network zener = parallel({k0, series({k1, c1})});
  BOOST_CHECK(without_names(zener, {}) == zener);
  BOOST_CHECK(without_names(zener, {"c1"}) == k0);
  BOOST_CHECK(without_names(zener, {"k0"}) == series({k1, c1}));
  BOOST_TEST(!without_names(zener, {"k0", "k1"}).has_value());
}

BOOST_AUTO_TEST_CASE(a_gap_in_a_graph_leaves_its_neighbours_without_load) {
  // a-c, c-b, c-d, d-b: without d-b the edge c-d dangles.
  const Network network{graph(4, {{0, 2}, {2, 1}, {2, 3}, {3, 1}})};
  const auto left =
      without(network, [](const Element& e) { return e.coefficient.symbol().name == "k3"; });
  BOOST_REQUIRE(left);
  BOOST_TEST(symbols_of(*left).size() == 2);
}

BOOST_AUTO_TEST_SUITE_END()
